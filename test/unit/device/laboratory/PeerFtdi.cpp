// SPDX-License-Identifier: BSD-3-Clause

// A substitute of libftdi1 with a Falcon behind it: its boot loader, its firmware's packets, its
// encoders and motors. Only what the plug-in calls.

#include <ftdi.h>

#include <cstring>
#include <deque>
#include <optional>
#include <vector>

#include "FalconModel.h"
#include "FalconPackets.h"
#include "PeerState.h"

namespace {

using namespace perilymph;
using test::PeerState;

constexpr double centerZ = 0.125;  // of the plug-in's frame D [m]
constexpr double pi = 3.14159265358979323846;

/// What libnifalcon documents: 320 slots counted four times, 14.25 mm on 110 mm, 35 degrees at home.
int countOf(double angle)
{
  const double degrees = angle * 180.0 / pi - 35.0;
  return static_cast<int>(std::lround(degrees / 360.0 * 1280.0 * 110.0 / 14.25));
}

struct Falcon {
  PeerState* state = test::sharedPeer();
  std::optional<test::PeerHandle> handle;
  int baud = 0;
  int dtr = 0;
  bool wasRaised = false;  // DTR, before the greeting
  bool isLoading = false;
  std::vector<std::uint8_t> received;
  std::deque<std::uint8_t> answers;

  bool isGone() const
  {
    return state == nullptr || state->fault == PeerState::absent ||
           state->fault == PeerState::unplugged;
  }
  void answer(const std::vector<std::uint8_t>& bytes)
  {
    answers.insert(answers.end(), bytes.begin(), bytes.end());
  }

  void takePacket(const novint::Packet& packet)
  {
    std::array<double, 3> torques{};
    for (std::size_t i = 0; i < 3; ++i) {
      int value = 0;
      for (int k = 3; k >= 0; --k) value = 16 * value + (packet[1 + 4 * i + std::size_t(k)] - 'A');
      if (value >= 32768) value -= 65536;
      torques[i] = -value / 10'000.0;
    }
    const bool isHoming = ((packet[13] - 'A') & 1) != 0;
    auto place = handle->position();
    place[2] += centerZ;
    handle->render(test::forceOf(torques, place));
    novint::Packet out;
    out.fill('A');
    out.front() = '<';
    out.back() = '>';
    const bool isHomed = isHoming && state->isReady != 0;
    for (std::size_t i = 0; i < 3; ++i) {
      // Before homing the counts begin anywhere.
      const int count = countOf(test::thighAngle(i, place)) + (isHomed ? 0 : 777);
      for (std::size_t k = 0; k < 4; ++k)
        out[1 + 4 * i + k] = static_cast<std::uint8_t>('A' + ((count >> (4 * k)) & 15));
    }
    const unsigned pressed = state->buttons;
    const unsigned grip = ((pressed & 1) << 2) | ((pressed & 2) >> 1);  // center, right
    out[13] = static_cast<std::uint8_t>('A' + grip + (isHomed ? 0x70 : 0));
    answer({out.begin(), out.end()});
  }

  void take(const std::uint8_t* bytes, int count)
  {
    received.insert(received.end(), bytes, bytes + count);
    if (baud == 9600 && wasRaised) {
      const std::vector<std::uint8_t> greeting = {0x0a, 0x43, 0x0d};
      if (received == greeting) answer({0x00, 0x0a, 0x44, 0x2c, 0x0d});
      received.clear();
    } else if (baud == 140'000 && dtr == 0) {
      for (const std::uint8_t byte : received) {
        answer({byte});
        if (isLoading) {
          ++state->firmwareBytes;
          state->firmwareSum += byte;
        }
        isLoading = isLoading || byte == 0x41;
      }
      received.clear();
    } else if (baud == 1'456'312) {
      while (received.size() >= 16) {
        novint::Packet packet;
        std::copy_n(received.begin(), 16, packet.begin());
        received.erase(received.begin(), received.begin() + 16);
        if (state->hasFirmware != 0) takePacket(packet);
      }
    }
  }
};

Falcon* falcon = nullptr;

}  // namespace

extern "C" {

ftdi_context* ftdi_new() { return new ftdi_context{}; }
void ftdi_free(ftdi_context* context) { delete context; }
const char* ftdi_get_error_string(ftdi_context*) { return "device not found"; }

int ftdi_usb_open(ftdi_context*, int vendor, int product)
{
  if (vendor != 0x0403 || product != 0xcb48) return -3;
  delete falcon;
  falcon = new Falcon;
  if (falcon->isGone()) return -3;
  falcon->handle.emplace(*falcon->state);
  ++falcon->state->opened;
  return 0;
}
int ftdi_usb_close(ftdi_context*)
{
  if (falcon != nullptr && falcon->handle) ++falcon->state->closed;
  delete falcon;
  falcon = nullptr;
  return 0;
}
int ftdi_usb_reset(ftdi_context*) { return 0; }
int ftdi_tcioflush(ftdi_context*)
{
  falcon->answers.clear();
  return 0;
}
int ftdi_set_latency_timer(ftdi_context*, unsigned char) { return falcon->isGone() ? -1 : 0; }
int ftdi_set_baudrate(ftdi_context*, int rate)
{
  if (rate == 1'456'312 && falcon->isLoading) falcon->state->hasFirmware = 1;
  falcon->baud = rate;
  falcon->received.clear();
  return 0;
}
int ftdi_set_line_property(ftdi_context*, ftdi_bits_type bits, ftdi_stopbits_type stop,
                           ftdi_parity_type parity)
{
  return bits == BITS_8 && stop == STOP_BIT_1 && parity == NONE ? 0 : -1;
}
int ftdi_setflowctrl(ftdi_context*, int) { return 0; }
int ftdi_setrts(ftdi_context*, int) { return 0; }
int ftdi_setdtr(ftdi_context*, int on)
{
  falcon->wasRaised = falcon->wasRaised || on != 0;
  falcon->dtr = on;
  return 0;
}
int ftdi_write_data(ftdi_context*, const unsigned char* bytes, int count)
{
  if (falcon->isGone()) return -666;  // libftdi: USB device unavailable
  falcon->take(bytes, count);
  return count;
}
int ftdi_read_data(ftdi_context*, unsigned char* bytes, int count)
{
  if (falcon->isGone()) return -666;
  int read = 0;
  // While it is silent, answers wait in the converter.
  const bool isSilent = falcon->state->fault == PeerState::silent;
  for (; !isSilent && read < count && !falcon->answers.empty(); ++read) {
    bytes[read] = falcon->answers.front();
    falcon->answers.pop_front();
  }
  falcon->state->unread = falcon->answers.size();
  if (read == 0) test::elapse(1'000'000);  // the converter's own packet, once per millisecond
  return read;
}

}  // extern "C"
