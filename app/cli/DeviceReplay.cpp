#include "DeviceReplay.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "OutputFile.h"
#include "perilymph/device/HidNodes.h"
#include "perilymph/device/TapeReading.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string ms(double time) { return fixed(time * 1e3, 3); }
std::string mm(double length) { return fixed(length * 1e3, 2); }

Json described(const device::ReportTape& tape, const std::string& profile,
               const device::TapeReading& told)
{
  const device::ReadingFigures& reading = told.reading;
  return {{"name", tape.name},
          {"vendor_id", tape.identity.vendor},
          {"product_id", tape.identity.product},
          {"profile", profile},
          {"duration_s", told.duration},
          {"reports", reading.fresh},
          {"lost", reading.lost},
          {"duplicates", reading.duplicates},
          {"old", reading.old},
          {"foreign", reading.foreign},
          {"not_kept", tape.lost},
          {"rate_per_s", reading.rate},
          {"interval_median_s", reading.intervalMedian},
          {"interval_p99_s", reading.intervalP99},
          {"interval_max_s", reading.intervalMost},
          {"least_position_m", told.least_D},
          {"most_position_m", told.most_D},
          {"buttons", told.buttons},
          {"outputs", told.writing.accepted},
          {"outputs_refused", told.writing.refused},
          {"write_median_s", told.writing.timeMedian},
          {"write_p99_s", told.writing.timeP99},
          {"write_max_s", told.writing.timeMost}};
}

void print(const device::ReportTape& tape, const std::string& profile,
           const device::TapeReading& told)
{
  const device::ReadingFigures& reading = told.reading;
  std::printf("%s  %s\n    read as %s\n", device::identityText(tape.identity).c_str(),
              tape.name.c_str(), profile.c_str());
  std::printf(
      "%-18s %s s; %s reports a second; between two: median %s ms, 99 %% below %s ms, "
      "longest %s ms\n",
      "on the tape", fixed(told.duration, 3).c_str(), fixed(reading.rate, 1).c_str(),
      ms(reading.intervalMedian).c_str(), ms(reading.intervalP99).c_str(),
      ms(reading.intervalMost).c_str());
  std::printf(
      "%-18s %llu fresh, %llu lost, %llu repeated, %llu old, %llu not understood, %llu not "
      "kept\n",
      "reports", static_cast<unsigned long long>(reading.fresh),
      static_cast<unsigned long long>(reading.lost),
      static_cast<unsigned long long>(reading.duplicates),
      static_cast<unsigned long long>(reading.old),
      static_cast<unsigned long long>(reading.foreign), static_cast<unsigned long long>(tape.lost));
  if (reading.fresh > 0)
    std::printf("%-18s x %s to %s mm, y %s to %s mm, z %s to %s mm; buttons 0x%x\n", "the hand",
                mm(told.least_D[0]).c_str(), mm(told.most_D[0]).c_str(),
                mm(told.least_D[1]).c_str(), mm(told.most_D[1]).c_str(),
                mm(told.least_D[2]).c_str(), mm(told.most_D[2]).c_str(), told.buttons);
  if (told.writing.accepted + told.writing.refused == 0) return;
  std::printf("%-18s %llu taken, %llu refused; median %s ms, 99 %% below %s ms, longest %s ms\n",
              "output reports", static_cast<unsigned long long>(told.writing.accepted),
              static_cast<unsigned long long>(told.writing.refused),
              ms(told.writing.timeMedian).c_str(), ms(told.writing.timeP99).c_str(),
              ms(told.writing.timeMost).c_str());
}

}  // namespace

Result<Done> replayDevice(const std::string& file, const std::string& json)
{
  const auto tape = device::loadTape(file);
  if (!tape) return tape.error();
  const auto descriptor = device::ReportDescriptor::parse(tape->descriptor);
  if (!descriptor) return Error{file + ": " + descriptor.error().message};
  const device::ProfileCatalog catalog = device::shippedProfiles();
  const device::DeviceProfile* const profile =
      device::matchingProfile(catalog.profiles, tape->identity, *descriptor);
  if (profile == nullptr)
    return Error{"No profile below plugins/devices fits the device on " + file + " (" + tape->name +
                 ", " + device::identityText(tape->identity) +
                 "). For a device of a known kind add one (plugins/README.md)."};
  auto codec = device::makeCodec(*profile, *descriptor);
  if (!codec) return codec.error();
  const device::TapeReading told = device::readTape(*tape, **codec, profile->traits.nominalPeriod);
  print(*tape, profile->name, told);
  if (json.empty()) return Done{};
  return writeWhole(json, described(*tape, profile->name, told).dump(2) + "\n");
}

}  // namespace perilymph::cli
