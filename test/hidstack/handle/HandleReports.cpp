// SPDX-License-Identifier: BSD-3-Clause
#include "HandleReports.h"

namespace perilymph::hidstack {

namespace {

// HID 1.11, section 6.2.2. All on a vendor's page: no kernel driver but hid-generic takes it.
constexpr std::uint8_t descriptor[] = {
    0x06, 0x50,         0xFF,              // usage page 0xFF50, vendor's own
    0x09, 0x01,                            // usage 1: the handle
    0xA1, 0x01,                            // collection, application
    0x85, inputNumber,                     //   report 1
    0x09, 0x10,                            //   usage 0x10: sequence
    0x15, 0x00,                            //   logical minimum 0
    0x27, 0xFF,         0xFF, 0x00, 0x00,  //   logical maximum 65535
    0x75, 0x10,                            //   16 bits
    0x95, 0x01,                            //   1 field
    0x81, 0x02,                            //   input, variable
    0x09, 0x11,                            //   usage 0x11: x
    0x09, 0x12,                            //   usage 0x12: y
    0x09, 0x13,                            //   usage 0x13: z
    0x17, 0x01,         0x00, 0x00, 0x80,  //   logical minimum -2147483647
    0x27, 0xFF,         0xFF, 0xFF, 0x7F,  //   logical maximum 2147483647
    0x75, 0x20,                            //   32 bits
    0x95, 0x03,                            //   3 fields
    0x81, 0x02,                            //   input, variable
    0x09, 0x14,                            //   usage 0x14: buttons
    0x15, 0x00,                            //   logical minimum 0
    0x26, 0xFF,         0x00,              //   logical maximum 255
    0x75, 0x08,                            //   8 bits
    0x95, 0x01,                            //   1 field
    0x81, 0x02,                            //   input, variable
    0x85, outputNumber,                    //   report 2
    0x09, 0x21,                            //   usage 0x21: force along x
    0x09, 0x22,                            //   usage 0x22: along y
    0x09, 0x23,                            //   usage 0x23: along z
    0x16, 0x01,         0x80,              //   logical minimum -32767
    0x26, 0xFF,         0x7F,              //   logical maximum 32767
    0x75, 0x10,                            //   16 bits
    0x95, 0x03,                            //   3 fields
    0x91, 0x02,                            //   output, variable
    0xC0,                                  // end of collection
};

/// Little-endian, as every number on HID.
template <class Number>
std::uint8_t* put(std::uint8_t* place, Number number)
{
  auto bits = static_cast<std::uint32_t>(number);
  for (std::size_t i = 0; i < sizeof(Number); ++i, bits >>= 8)
    *place++ = static_cast<std::uint8_t>(bits & 0xFFu);
  return place;
}

template <class Number>
Number take(const std::uint8_t*& place)
{
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bits |= static_cast<std::uint32_t>(*place++) << (8 * i);
  return static_cast<Number>(bits);
}

}  // namespace

std::span<const std::uint8_t> reportDescriptor() { return descriptor; }

std::array<std::uint8_t, inputSize> encode(const InputReport& report)
{
  std::array<std::uint8_t, inputSize> bytes{inputNumber};
  std::uint8_t* place = put(bytes.data() + 1, report.sequence);
  for (const std::int32_t coordinate : report.place) place = put(place, coordinate);
  put(place, report.buttons);
  return bytes;
}

std::array<std::uint8_t, outputSize> encode(const OutputReport& report)
{
  std::array<std::uint8_t, outputSize> bytes{outputNumber};
  std::uint8_t* place = bytes.data() + 1;
  for (const std::int16_t component : report.force) place = put(place, component);
  return bytes;
}

std::optional<InputReport> decodeInput(std::span<const std::uint8_t> bytes)
{
  if (bytes.size() != inputSize || bytes[0] != inputNumber) return std::nullopt;
  const std::uint8_t* place = bytes.data() + 1;
  InputReport report;
  report.sequence = take<std::uint16_t>(place);
  for (std::int32_t& coordinate : report.place) coordinate = take<std::int32_t>(place);
  report.buttons = take<std::uint8_t>(place);
  return report;
}

std::optional<OutputReport> decodeOutput(std::span<const std::uint8_t> bytes)
{
  if (bytes.size() != outputSize || bytes[0] != outputNumber) return std::nullopt;
  const std::uint8_t* place = bytes.data() + 1;
  OutputReport report;
  for (std::int16_t& component : report.force) component = take<std::int16_t>(place);
  return report;
}

}  // namespace perilymph::hidstack
