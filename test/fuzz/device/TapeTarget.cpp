// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the report tape with any text, decoded as a joystick.

#include <string>

#include "Descriptors.h"
#include "FuzzTarget.h"
#include "perilymph/test/DeviceProfiles.h"
#include "tape/TapeReader.h"

namespace perilymph::fuzz {

namespace {

Bytes seedOf(const std::vector<std::uint8_t>& descriptor)
{
  device::ReportTape tape;
  tape.name = "A stick";
  tape.bus = 3;
  tape.identity = {0x1209, 1, -1};
  tape.descriptor = descriptor;
  std::string text = device::tapeHead(tape);
  device::RawReport report;
  report.size = 5;
  report.bytes[0] = 1;
  for (const auto event :
       {device::TapeEvent::input, device::TapeEvent::written, device::TapeEvent::refused,
        device::TapeEvent::featureSet, device::TapeEvent::featureGot, device::TapeEvent::input,
        device::TapeEvent::gone})
    text += device::tapeLine(event, 12'345'678, 977'000, report);
  return {text.begin(), text.end()};
}

}  // namespace

std::vector<Bytes> seeds()
{
  const std::string recorded =
      "D: 0\nR: 3 05 01 c0\nN: x\nP: y\nI: 3 1209 0001\nE: 000000.000000 4 00 01 00 00\n";
  return {
      seedOf(device::test::joystickDescriptor()), seedOf({}), {recorded.begin(), recorded.end()}};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static const auto profile = *device::parseProfile(test::stickProfile(), "stick");
  static const auto codec = *device::makeCodec(
      profile, *device::ReportDescriptor::parse(device::test::joystickDescriptor()));
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto tape = device::parseTape(text, "input");
  if (!tape) {
    fuzz::promise(!tape.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  std::int64_t last = 0;
  for (const device::TapeEntry& entry : tape->entries) {
    fuzz::promise(entry.time >= last, "entries are in order");
    fuzz::promise(entry.bytes.size() <= device::longestReport, "a report has its greatest length");
    last = entry.time;
  }
  const device::TapeReading told = device::readTape(*tape, *codec, 10e-3);
  fuzz::promise(told.duration >= 0.0 && told.reading.fresh <= tape->entries.size(),
                "no more is told than is on the tape");
  return 0;
}
