// SPDX-License-Identifier: BSD-3-Clause
#include "FalconPort.h"

#include <ftdi.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "DeviceLink.h"

namespace perilymph::novint {

namespace {

// All from libnifalcon 1.0: FalconComm.h, FalconCommLibFTDI.cpp, FalconFirmware.cpp.
constexpr int vendor = 0x0403, product = 0xcb48;
constexpr int normalRate = 1'456'312, greetingRate = 9600, loadingRate = 140'000;  // [baud]
constexpr std::array<std::uint8_t, 3> greeting = {0x0a, 0x43, 0x0d};
constexpr std::array<std::uint8_t, 4> greetingAnswer = {0x0a, 0x44, 0x2c, 0x0d};
constexpr std::uint8_t loadRequest = 0x41;
constexpr int chunk = 62;  // one USB packet with the two bytes of the converter's state
constexpr int greetings = 10, packetTries = 10;

constexpr std::int64_t replyPatience = 20'000'000;      // [ns]; twenty times the usual
constexpr std::int64_t loaderPatience = 1'000'000'000;  // [ns]
constexpr int usbTimeout = 20;                          // [ms]

}  // namespace

void CloseFtdi::operator()(ftdi_context* context) const noexcept
{
  ftdi_usb_close(context);
  ftdi_free(context);
}

std::string FalconPort::open(const std::string& firmware)
{
  context_.reset(ftdi_new());
  if (!context_) return "libftdi1 cannot be used; install the package libftdi1-2 again.";
  context_->usb_read_timeout = usbTimeout;
  context_->usb_write_timeout = usbTimeout;
  if (ftdi_usb_open(context_.get(), vendor, product) < 0) {
    const std::string why = ftdi_get_error_string(context_.get());
    context_.reset();
    return "No Novint Falcon can be opened (USB 0403:cb48): " + why +
           ". Check its cable and power, and the udev rule of the guide.";
  }
  std::string error;
  if (!setNormalMode())
    error = "The Novint Falcon refuses its settings; disconnect it from USB and connect it again.";
  else if (!answers())
    error = load(firmware);
  if (!error.empty()) context_.reset();
  return error;
}

bool FalconPort::setNormalMode() noexcept
{
  return ftdi_set_latency_timer(context_.get(), 1) == 0 &&
         ftdi_set_baudrate(context_.get(), normalRate) == 0 && ftdi_tcioflush(context_.get()) == 0;
}

bool FalconPort::answers() noexcept
{
  for (int i = 0; i < packetTries; ++i) {
    Packet packet;
    if (!send(encoded({}, redLight))) return false;
    if (receive(packet) == Reply::complete && decoded(packet)) return true;
  }
  return false;
}

std::string FalconPort::load(const std::string& firmware)
{
  if (firmware.empty())
    return "The Novint Falcon has no firmware yet. Set PERILYMPH_FALCON_FIRMWARE to the path of "
           "your copy, which came with the device's drivers.";
  std::ifstream file(firmware, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file.good() && bytes.empty())
    return "The firmware of the Novint Falcon, " + firmware +
           ", cannot be read or is empty. Correct PERILYMPH_FALCON_FIRMWARE.";
  const std::string failed =
      "The Novint Falcon did not accept the firmware " + firmware +
      ". Switch its power off and on; if that recurs, use the firmware of the device's drivers.";
  if (!enterLoader()) return failed;
  const int size = static_cast<int>(bytes.size());
  for (int at = 0; at < size; at += chunk) {
    const int count = std::min(chunk, size - at);
    std::array<std::uint8_t, chunk> echo{};
    if (ftdi_write_data(context_.get(), bytes.data() + at, count) != count ||
        readAtMost(echo.data(), count, loaderPatience) != count ||
        std::memcmp(echo.data(), bytes.data() + at, static_cast<std::size_t>(count)) != 0)
      return failed;
  }
  return setNormalMode() && answers() ? std::string() : failed;
}

bool FalconPort::enterLoader() noexcept
{
  ftdi_context* const port = context_.get();
  // With less latency the greeting is not answered.
  const bool isSet = ftdi_usb_reset(port) == 0 && ftdi_set_latency_timer(port, 16) == 0 &&
                     ftdi_tcioflush(port) == 0 && ftdi_set_baudrate(port, greetingRate) == 0 &&
                     ftdi_set_line_property(port, BITS_8, STOP_BIT_1, NONE) == 0 &&
                     ftdi_setflowctrl(port, SIO_DISABLE_FLOW_CTRL) == 0 &&
                     ftdi_setrts(port, 0) == 0 && ftdi_setdtr(port, 0) == 0 &&
                     ftdi_setdtr(port, 1) == 0;
  bool isGreeted = false;
  for (int i = 0; isSet && !isGreeted && i < greetings; ++i) {
    std::array<std::uint8_t, 5> answer{};  // a zero may come first
    if (ftdi_write_data(port, greeting.data(), greeting.size()) != greeting.size()) return false;
    const int count = readAtMost(answer.data(), answer.size(), loaderPatience / greetings);
    if (count < 0) return false;
    isGreeted = std::search(answer.begin(), answer.begin() + count, greetingAnswer.begin(),
                            greetingAnswer.end()) != answer.begin() + count;
  }
  if (!isGreeted || ftdi_setdtr(port, 0) != 0 || ftdi_set_baudrate(port, loadingRate) != 0)
    return false;
  std::uint8_t answer = 0;
  return ftdi_write_data(port, &loadRequest, 1) == 1 &&
         readAtMost(&answer, 1, loaderPatience) == 1 && answer == loadRequest;
}

bool FalconPort::send(const Packet& packet) noexcept
{
  constexpr int size = 16;
  // Answers that come too late would from now on be taken for those of later packets.
  if (context_ && isLate_ && ftdi_tcioflush(context_.get()) != 0) return false;
  isLate_ = false;
  return context_ && ftdi_write_data(context_.get(), packet.data(), size) == size;
}

Reply FalconPort::receive(Packet& packet) noexcept
{
  if (!context_) return Reply::lost;
  const std::int64_t end = plugin::now() + replyPatience;
  int have = 0;
  while (have < 16) {
    const int count = readAtMost(packet.data() + have, 16 - have, end - plugin::now());
    if (count < 0) return Reply::lost;
    have += count;
    // The rest of an answer that came too late is not the beginning of this one.
    const auto begin = std::find(packet.begin(), packet.begin() + have, '<');
    std::copy(begin, packet.begin() + have, packet.begin());
    have -= static_cast<int>(begin - packet.begin());
    if (have < 16 && plugin::now() >= end) {
      isLate_ = true;
      return Reply::late;
    }
  }
  return Reply::complete;
}

int FalconPort::readAtMost(std::uint8_t* bytes, int count, std::int64_t patience) noexcept
{
  const std::int64_t end = plugin::now() + patience;
  int have = 0;
  do {
    const int got = ftdi_read_data(context_.get(), bytes + have, count - have);
    if (got < 0) return -1;
    have += got;
  } while (have < count && plugin::now() < end);
  return have;
}

}  // namespace perilymph::novint
