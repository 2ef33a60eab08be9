// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes a codec with any descriptor, reports, forces, and answers of the device.

#include <cmath>
#include <cstring>
#include <string>

#include "Descriptors.h"
#include "FuzzTarget.h"
#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "perilymph/test/DeviceProfiles.h"

namespace perilymph::fuzz {

namespace {

using device::DeviceProfile;
using device::DeviceSample;
using device::RawReport;
using device::ReportList;
using device::Transfer;

/// A device that accepts reports and answers as the input specifies.
class AnyDevice final : public device::Transport {
public:
  explicit AnyDevice(InputReader& input) : input_(input) {}

  Transfer read(RawReport&, Duration) noexcept override { return Transfer::nothing; }
  Transfer write(const RawReport& report) noexcept override
  {
    promise(report.size >= 1 && report.size <= device::longestReport, "a report of some length");
    return answer();
  }
  Transfer setFeature(const RawReport& report) noexcept override { return write(report); }
  Transfer getFeature(RawReport& report) noexcept override
  {
    const std::size_t capacity = report.size;
    const auto said = input_.bytes(capacity > 0 ? capacity - 1 : 0);
    std::copy(said.begin(), said.end(), report.bytes.begin() + 1);
    report.size = 1 + said.size();
    return answer();
  }

private:
  Transfer answer() noexcept
  {
    const std::uint8_t said = input_.byte();
    return said < 200 ? Transfer::done : said < 240 ? Transfer::failed : Transfer::gone;
  }

  InputReader& input_;
};

double anyNumber(InputReader& input)
{
  const auto bytes = input.bytes(sizeof(double));
  double number = 0.0;
  std::memcpy(&number, bytes.data(), bytes.size());
  return number;
}

/// Its numbers start at odd bits and have the maximum length.
const std::string vectorProfile = test::profileHead("vector") + R"(nominal_period_ms = 1.0
max_force_N = 2.0
[mount]
grasp_button = 32
[input]
report = 1
bytes = 21
bits = 32
first_bits = [3, 35, 67]
quantum_mm = [0.01, 0.01, 0.02]
counter_bit = 99
counter_bits = 32
buttons_bit = 131
buttons = 32
[output]
report = 5
bytes = 13
bits = 31
first_bits = [1, 32, 63]
quantum_N = [0.001, 0.001, 1e-6]
)";

/// The shipped profiles, a plain vector profile, and a PID profile for each encoding of a
/// direction.
std::vector<DeviceProfile> profiles()
{
  std::vector<DeviceProfile> all = device::shippedProfiles().profiles;
  promise(all.size() >= 5, "profiles are shipped");
  const auto vector = device::parseProfile(vectorProfile, "vector");
  promise(static_cast<bool>(vector), "the vector profile is right");
  all.push_back(*vector);
  using Effects = device::PidLayout::Effects;
  const std::vector<DeviceProfile> shipped = all;
  for (const DeviceProfile& profile : shipped)
    if (profile.kind == device::CodecKind::pid)
      for (const Effects effects : {Effects::axes, Effects::direction}) {
        all.push_back(profile);
        all.back().pid.effects = effects;
      }
  return all;
}

void checkHand(const DeviceSample& hand)
{
  double squared = 0.0;
  for (const double coordinate : hand.position_D)
    promise(std::isfinite(coordinate) && std::fabs(coordinate) < 1e6, "a finite place");
  for (const double part : hand.rotation_D) squared += part * part;
  promise(std::fabs(squared - 1.0) < 1e-9, "a rotation of unit length");
}

void run(device::DeviceCodec& codec, InputReader& input)
{
  DeviceSample hand;
  ReportList reports;
  AnyDevice device(input);
  const bool begins = (input.byte() & 1u) != 0;
  if (begins) {
    const auto begun = codec.begin(device);
    if (!begun) promise(!begun.error().message.empty(), "a refusal has a sentence");
  }
  for (int i = 0; i < 16 && !input.isEmpty(); ++i) {
    RawReport report;
    report.size = input.byte() % 72u;
    const auto bytes = input.bytes(report.size);
    std::copy(bytes.begin(), bytes.end(), report.bytes.begin());
    codec.decode(report, hand);
    checkHand(hand);

    codec.encode({{anyNumber(input), anyNumber(input), anyNumber(input)}, {}}, reports);
    promise(reports.count <= ReportList::capacity, "no more reports than there is room");
    for (std::size_t k = 0; k < reports.count; ++k) device.write(reports.reports[k]);
  }
  codec.end(device);
}

}  // namespace

std::vector<Bytes> seeds()
{
  using namespace device::test;
  // A device that creates two effects (four bytes each: block, status, free memory) and accepts
  // everything else, then two reports with forces.
  Bytes conversation{1, 0, 0, 0};
  for (const int block : {1, 2})
    for (const int byte : {0, block, 1, 0, 0, 0, 0, 0, 0})
      conversation.push_back(static_cast<std::uint8_t>(byte));
  conversation.push_back(0);
  for (const int number : {1, 0}) {
    conversation.push_back(23);  // length of the report
    conversation.push_back(static_cast<std::uint8_t>(number));
    for (int i = 0; i < 22; ++i) conversation.push_back(static_cast<std::uint8_t>(11 * i));
    for (int i = 0; i < 3; ++i)  // 1.0 as a double
      for (const int byte : {0, 0, 0, 0, 0, 0, 0xf0, 0x3f})
        conversation.push_back(static_cast<std::uint8_t>(byte));
  }

  std::vector<Bytes> all;
  const auto known = profiles();
  for (std::size_t kind = 0; kind < known.size(); ++kind) {
    const bool isPid = known[kind].kind == device::CodecKind::pid;
    // A PID device's own descriptor four times: others are soon refused.
    const std::vector<Bytes> fit = isPid
                                       ? std::vector<Bytes>(4, pidDescriptor())
                                       : std::vector<Bytes>{joystickDescriptor(), knobDescriptor(),
                                                            combinedKnobDescriptor(), Bytes{}};
    for (const Bytes& descriptor : fit) {
      Bytes input{static_cast<std::uint8_t>(kind),
                  static_cast<std::uint8_t>(descriptor.size() >> 8),
                  static_cast<std::uint8_t>(descriptor.size() & 0xff)};
      for (const Bytes& part : {descriptor, conversation})
        for (const std::uint8_t byte : part) input.push_back(byte);
      all.push_back(input);
    }
  }
  return all;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static const std::vector<device::DeviceProfile> profiles = fuzz::profiles();
  fuzz::InputReader input({data, size});
  const device::DeviceProfile& profile = profiles[input.byte() % profiles.size()];
  const std::size_t high = input.byte();
  const std::size_t length = high << 8 | input.byte();
  const auto descriptor = device::ReportDescriptor::parse(input.bytes(length));
  const auto codec =
      device::makeCodec(profile, descriptor ? *descriptor : device::ReportDescriptor());
  if (!codec) {
    fuzz::promise(!codec.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::run(**codec, input);
  return 0;
}
