// SPDX-License-Identifier: BSD-3-Clause
#include "codec/AxesReader.h"
#include "codec/PidCodec.h"
#include "codec/PlainCodec.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::device {

namespace {

using CodecResult = Result<std::unique_ptr<DeviceCodec>>;

/// Whether reports with fixed positions have the length declared by the device.
Result<void> checkLengths(const DeviceProfile& profile, const ReportDescriptor& descriptor)
{
  if (descriptor.fields().empty()) return {};
  const auto check = [&](ReportKind kind, const VectorLayout& layout, const char* what) {
    const std::size_t real = descriptor.reportBytes(kind, layout.report);
    if (layout.bytes == 0 || real >= layout.bytes) return Result<void>();
    return Result<void>(
        Error{"The profile %1 does not fit the device: its %2 report %3 should have %4 bytes and "
              "has %5. Put right 'report' and 'bytes' in the profile, or take another one.",
              profile.file, what, layout.report, layout.bytes, real});
  };
  auto fits = check(ReportKind::input, profile.plain.input, "input");
  if (fits) fits = check(ReportKind::output, profile.plain.output, "output");
  return fits;
}

CodecResult makePid(const DeviceProfile& profile, const ReportDescriptor& descriptor)
{
  auto reader = AxesReader::make(profile, descriptor);
  if (!reader) return reader.error();
  auto reports = PidReports::find(profile, descriptor);
  if (!reports) return reports.error();
  return std::unique_ptr<DeviceCodec>(std::make_unique<PidCodec>(profile, *reader, *reports));
}

int movedAxes(const DeviceProfile& profile, std::size_t from)
{
  int moved = 0;
  for (std::size_t i = from; i < from + 3; ++i)
    moved += profile.axes.axes[i].usage.page != 0 ? 1 : 0;
  return moved;
}

/// Adds the resolution of a joystick, that of its coarsest axis.
void addSteps(const DeviceProfile& profile, const ReportDescriptor& descriptor,
              DeviceTraits& traits)
{
  const auto reader = AxesReader::make(profile, descriptor);
  if (!reader) return;
  traits.buttons = reader->buttons();
  if (profile.axes.motion == AxesLayout::Motion::place)
    for (std::size_t i = 0; i < 3; ++i)
      if (reader->halfRange(i) > 0.0)
        traits.positionQuantum =
            std::max(traits.positionQuantum, profile.axes.travel / reader->halfRange(i));
  if (profile.kind != CodecKind::pid) return;
  const auto reports = PidReports::find(profile, descriptor);
  if (reports) traits.forceQuantum = traits.maxForce / static_cast<double>(reports->maxMagnitude());
}

/// Handle displacement per count of the coarsest encoder, with the arm stretched out.
double linkageStep(const Linkage& linkage)
{
  const std::array<double, 3> lever{linkage.lengthB + linkage.lengthC, linkage.lengthB,
                                    linkage.lengthC};
  double step = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    step = std::max(step, lever[i] * (2.0 * pi) / linkage.countsPerTurn[i] *
                              std::fabs(linkage.bodyTurnsPerTurn[i]));
  return step;
}

}  // namespace

CodecResult makeCodec(const DeviceProfile& profile, const ReportDescriptor& descriptor)
{
  if (profile.kind == CodecKind::encoders || profile.kind == CodecKind::vector) {
    if (const auto fits = checkLengths(profile, descriptor); !fits) return fits.error();
    return std::unique_ptr<DeviceCodec>(std::make_unique<PlainCodec>(profile));
  }
  if (descriptor.fields().empty())
    return Error{
        "The profile %1 finds axes by their usage, but the device's report descriptor is empty or "
        "unreadable. Check that the device may be opened.",
        profile.file};
  if (profile.kind == CodecKind::pid) return makePid(profile, descriptor);
  auto reader = AxesReader::make(profile, descriptor);
  if (!reader) return reader.error();
  return std::unique_ptr<DeviceCodec>(std::make_unique<AxesCodec>(profile, *reader));
}

DeviceTraits traitsOf(const DeviceProfile& profile, const ReportDescriptor& descriptor)
{
  DeviceTraits traits = profile.traits;
  if (profile.kind == CodecKind::encoders || profile.kind == CodecKind::vector) {
    const PlainLayout& plain = profile.plain;
    const auto coarsest = [](const Vector3& steps) {
      return *std::max_element(steps.begin(), steps.end());
    };
    traits.actuatedTranslations = traits.rendersForce ? traits.sensedTranslations : 0;
    traits.buttons = plain.buttons ? static_cast<int>(plain.buttons->bits) : 0;
    const bool isVector = profile.kind == CodecKind::vector;
    traits.positionQuantum = isVector ? coarsest(plain.inputQuantum) : linkageStep(plain.linkage);
    if (isVector && traits.rendersForce) traits.forceQuantum = coarsest(plain.outputQuantum);
    return traits;
  }
  traits.sensedTranslations = movedAxes(profile, 0);
  traits.sensedRotations = movedAxes(profile, 3);
  traits.actuatedTranslations = traits.rendersForce ? traits.sensedTranslations : 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (profile.axes.axes[i].usage.page != 0) traits.actuatedAxes |= 1u << i;
  if (!descriptor.fields().empty()) addSteps(profile, descriptor, traits);
  return traits;
}

}  // namespace perilymph::device
