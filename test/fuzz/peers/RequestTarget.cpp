// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the stream of an OpenIGTLink client, in pieces of any size.

#include <igtlImageMessage.h>
#include <igtlPolyDataMessage.h>
#include <igtlTransformMessage.h>
#include <igtl_util.h>

#include <algorithm>
#include <string>

#include "FuzzTarget.h"
#include "RequestReader.h"

namespace perilymph::fuzz {

namespace {

using broadcast::RequestReader;

Bytes packed(igtl::MessageBase& message, const char* name)
{
  message.SetDeviceName(name);
  message.Pack();
  const auto* const begin = static_cast<const std::uint8_t*>(message.GetPackPointer());
  return {begin, begin + message.GetPackSize()};
}

/// What a reader finds in a stream.
struct Found {
  std::vector<std::string> requests;
  std::string fault;
  bool isWithinMessage = false;
};

/// @param piece  Bytes that arrive at a time, 1 or more.
Found found(std::span<const std::uint8_t> stream, std::size_t piece)
{
  Found result;
  RequestReader reader;
  while (!stream.empty() && reader.fault().empty()) {
    auto arrived = stream.first(std::min(piece, stream.size()));
    stream = stream.subspan(arrived.size());
    while (!arrived.empty() && reader.fault().empty()) {
      const std::size_t taken = reader.take(arrived);
      promise(taken > 0 && taken <= arrived.size(), "bytes are taken, and no more than came");
      arrived = arrived.subspan(taken);
      if (!reader.request()) continue;
      promise(!reader.isWithinMessage(), "a message that is complete has ended");
      const auto& [type, device] = *reader.request();
      promise(!type.empty() && type.size() <= 12 && device.size() <= 20, "fields have their size");
      for (const char c : type + device) promise(c >= ' ' && c < 0x7f, "names are printable");
      result.requests.push_back(type + "|" + device);
    }
  }
  result.fault = reader.fault();
  result.isWithinMessage = reader.isWithinMessage();
  return result;
}

/// A message with any body and the right check sum is read, and dropped.
void checkWholeMessage(std::span<const std::uint8_t> body)
{
  Bytes message(RequestReader::headerSize, 0);
  message[1] = 2;
  const std::string type = "STRING";
  std::copy(type.begin(), type.end(), message.begin() + 2);
  Bytes copy(body.begin(), body.end());
  const std::uint64_t sum = crc64(copy.data(), copy.size(), crc64(nullptr, 0, 0));
  for (std::size_t i = 0; i < 8; ++i) {
    message[42 + i] = static_cast<std::uint8_t>(body.size() >> (56 - 8 * i));
    message[50 + i] = static_cast<std::uint8_t>(sum >> (56 - 8 * i));
  }
  message.insert(message.end(), body.begin(), body.end());
  const Found result = found(message, 13);
  promise(result.fault.empty() && result.requests == std::vector<std::string>{"STRING|"},
          "a valid message is read");
}

}  // namespace

std::vector<Bytes> seeds()
{
  const Bytes polygons = packed(*igtl::GetPolyDataMessage::New(), "PerilymphScala");
  Bytes several = packed(*igtl::GetImageMessage::New(), "");
  const Bytes transform = packed(*igtl::TransformMessage::New(), "Other");
  several.insert(several.end(), transform.begin(), transform.end());
  several.insert(several.end(), polygons.begin(), polygons.end());
  return {polygons, transform, several};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  const std::span<const std::uint8_t> stream(data, size);
  const fuzz::Found whole = fuzz::found(stream, std::max<std::size_t>(size, 1));
  const fuzz::Found pieces = fuzz::found(stream, 1 + (size == 0 ? 0 : stream.back() % 70));
  fuzz::promise(whole.requests == pieces.requests && whole.fault == pieces.fault &&
                    whole.isWithinMessage == pieces.isWithinMessage,
                "the sizes of the pieces make no difference");
  fuzz::checkWholeMessage(stream);
  return 0;
}
