// SPDX-License-Identifier: BSD-3-Clause
#include "RequestReader.h"

#include <igtl_util.h>

#include <algorithm>
#include <cctype>

namespace perilymph::broadcast {

namespace {

std::uint64_t bigEndian(std::span<const std::uint8_t> bytes)
{
  std::uint64_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8 | byte;
  return value;
}

/// The text of a field, up to its first zero; nothing if it has other than printable characters.
std::optional<std::string> text(std::span<const std::uint8_t> field)
{
  const auto end = std::find(field.begin(), field.end(), 0);
  if (!std::all_of(field.begin(), end, [](std::uint8_t c) { return c >= 0x20 && c < 0x7f; }))
    return std::nullopt;
  return std::string(field.begin(), end);
}

}  // namespace

std::size_t RequestReader::take(std::span<const std::uint8_t> bytes)
{
  request_.reset();
  std::size_t taken = 0;
  while (fault_.empty() && !request_ && taken < bytes.size()) {
    const auto rest = bytes.subspan(taken);
    if (headerBytes_ < headerSize) {
      const std::size_t count = std::min(rest.size(), headerSize - headerBytes_);
      std::copy_n(rest.begin(), count, header_.begin() + static_cast<long>(headerBytes_));
      headerBytes_ += count;
      taken += count;
      if (headerBytes_ == headerSize) readHeader();
      continue;
    }
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(rest.size(), bodyLeft_));
    // The library's function takes a pointer to variable bytes, but only reads them.
    if (isSkipped_)
      skipped_ += count;
    else
      crc_ = crc64(const_cast<std::uint8_t*>(rest.data()), count, crc_);
    bodyLeft_ -= count;
    taken += count;
    if (bodyLeft_ == 0) finish();
  }
  return taken;
}

void RequestReader::readHeader()
{
  const std::span<const std::uint8_t> header(header_);
  const std::uint64_t version = bigEndian(header.first(2));
  const auto type = text(header.subspan(2, 12));
  const auto device = text(header.subspan(14, 20));
  bodyLeft_ = bigEndian(header.subspan(42, 8));
  statedCrc_ = bigEndian(header.subspan(50, 8));
  if (version < 1 || version > maxVersion)
    fault_ = "its header has version " + std::to_string(version) + ", not 1 to " +
             std::to_string(maxVersion);
  else if (!type || type->empty() || !device)
    fault_ = "its header has no valid type or name";
  isSkipped_ = bodyLeft_ > maxBody;
  if (!fault_.empty()) return;
  current_ = {*type, *device};
  crc_ = crc64(nullptr, 0, 0);
  if (bodyLeft_ == 0) finish();
}

void RequestReader::finish()
{
  headerBytes_ = 0;
  if (isSkipped_) return;
  // 0: the sender computed none.
  if (statedCrc_ != 0 && crc_ != statedCrc_) {
    fault_ = "the check sum of its " + current_.type + " is wrong";
    return;
  }
  request_ = current_;
}

}  // namespace perilymph::broadcast
