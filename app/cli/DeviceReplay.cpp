// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceReplay.h"
#include "JsonText.h"
#include "Terminal.h"

#include <nlohmann/json.hpp>

#include "perilymph/device/HidNodes.h"
#include "perilymph/device/TapeReading.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string ms(double time) { return fixed(time * 1e3, 3); }
std::string mm(double length) { return fixed(length * 1e3, 2); }

std::string hexadecimal(std::uint32_t number)
{
  char digits[16];
  std::snprintf(digits, sizeof digits, "0x%x", number);
  return digits;
}

Json described(const device::TapeReading& told)
{
  const device::ReadingFigures& reading = told.reading;
  return {{"name", told.name},
          {"vendor_id", told.identity.vendor},
          {"product_id", told.identity.product},
          {"profile", told.profile},
          {"duration_s", told.duration},
          {"reports", reading.fresh},
          {"lost", reading.lost},
          {"duplicates", reading.duplicates},
          {"old", reading.old},
          {"foreign", reading.foreign},
          {"not_kept", told.lost},
          {"rate_per_s", reading.rate},
          {"interval_median_s", reading.intervalMedian},
          {"interval_p99_s", reading.intervalP99},
          {"interval_max_s", reading.intervalMax},
          {"min_position_m", told.min_D},
          {"max_position_m", told.max_D},
          {"buttons", told.buttons},
          {"outputs", told.writing.accepted},
          {"outputs_refused", told.writing.refused},
          {"write_median_s", told.writing.timeMedian},
          {"write_p99_s", told.writing.timeP99},
          {"write_max_s", told.writing.timeMax}};
}

void printTape(const device::TapeReading& told)
{
  const device::ReadingFigures& reading = told.reading;
  print("{}  {}\n    read as {}\n", device::identityText(told.identity), told.name, told.profile);
  print(
      "{:18} {} s; {} reports/s; interval median {} ms, 99 % below {} ms, "
      "maximum {} ms\n",
      "recorded", fixed(told.duration, 3), fixed(reading.rate, 1), ms(reading.intervalMedian),
      ms(reading.intervalP99), ms(reading.intervalMax));
  print(
      "{:18} {} fresh, {} lost, {} repeated, {} outdated, {} invalid, {} not "
      "stored\n",
      "reports", reading.fresh, reading.lost, reading.duplicates, reading.old, reading.foreign,
      told.lost);
  if (reading.fresh > 0)
    print("{:18} x {} to {} mm, y {} to {} mm, z {} to {} mm; buttons {}\n", "device position",
          mm(told.min_D[0]), mm(told.max_D[0]), mm(told.min_D[1]), mm(told.max_D[1]),
          mm(told.min_D[2]), mm(told.max_D[2]), hexadecimal(told.buttons));
  if (told.writing.accepted + told.writing.refused == 0) return;
  print("{:18} {} taken, {} refused; median {} ms, 99 % below {} ms, maximum {} ms\n",
        "output reports", told.writing.accepted, told.writing.refused, ms(told.writing.timeMedian),
        ms(told.writing.timeP99), ms(told.writing.timeMax));
}

}  // namespace

Result<void> replayDevice(const std::string& file, const std::string& json)
{
  const auto told = device::readTape(file);
  if (!told) return told.error();
  printTape(*told);
  if (json.empty()) return {};
  return writeWhole(json, jsonText(described(*told)));
}

}  // namespace perilymph::cli
