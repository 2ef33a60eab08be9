// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the report descriptor with any bytes.

#include "Descriptors.h"
#include "FuzzTarget.h"
#include "codec/ReportBits.h"
#include "codec/ReportDescriptor.h"
#include "hid/Transport.h"

namespace perilymph::fuzz {

namespace {

using device::ReportDescriptor;
using device::ReportKind;

constexpr std::size_t maxBytes = device::longestReport - 1;

void lookAt(const ReportDescriptor& descriptor, std::size_t size)
{
  // Memory is bounded by the length of the descriptor, not by its content.
  std::size_t ranges = 0;
  for (const device::ReportField& field : descriptor.fields()) {
    ranges += field.usages.size();
    promise(field.bitsEach > 0 && field.count > 0, "a field has elements");
    promise(field.isConstant || field.bitsEach <= 32, "an element has 32 bits at most");
    const std::size_t end = field.bitOffset + std::size_t{field.bitsEach} * field.count;
    promise(end <= 8 * maxBytes, "a field ends within the longest report");
    promise(end <= 8 * descriptor.reportBytes(field.kind, field.report),
            "a field ends within its report");
    promise(field.collection < static_cast<std::int32_t>(descriptor.collections().size()),
            "a field's collection exists");
  }
  promise(descriptor.fields().size() <= size, "no more fields than bytes");
  promise(ranges <= size, "no more usages than bytes");
  for (const auto& collection : descriptor.collections())
    promise(collection.parent < static_cast<std::int32_t>(descriptor.collections().size()),
            "a collection's parent exists");
}

/// Every field found can be written and reads back as written.
void useSlots(const ReportDescriptor& descriptor)
{
  for (const ReportKind kind : {ReportKind::input, ReportKind::output, ReportKind::feature})
    for (std::uint16_t id = 0x30; id <= 0x35; ++id) {
      const auto slot = descriptor.find(kind, {0x01, id});
      if (!slot) continue;
      std::vector<std::uint8_t> report(descriptor.reportBytes(kind, slot->report));
      device::putNumber(report, *slot, slot->isSigned ? -1 : 1);
      promise(device::numberAt(report, *slot) == (slot->isSigned ? -1 : 1),
              "a number reads as it was written");
    }
  for (std::uint16_t id = 0x97; id <= 0x9a; ++id)
    descriptor.choice(ReportKind::output, {0x0f, id}, {0x0f, 0x96});
}

}  // namespace

std::vector<Bytes> seeds()
{
  using namespace device::test;
  return {joystickDescriptor(), knobDescriptor(), combinedKnobDescriptor(), pidDescriptor()};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  const auto descriptor = device::ReportDescriptor::parse({data, size});
  if (!descriptor) {
    fuzz::promise(!descriptor.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::lookAt(*descriptor, size);
  fuzz::useSlots(*descriptor);
  return 0;
}
