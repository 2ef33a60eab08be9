// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/Surgery.h"

#include <algorithm>
#include <cctype>

namespace perilymph::outcome {

namespace {

constexpr std::size_t maxLot = 24, maxLubricant = 40;
constexpr int maxContacts = 64, maxCount = 100, maxDays = 36'500;
constexpr Length maxDepth = millimeters(40);

template <class Value>
Result<void> within(const std::optional<Value>& value, Value low, Value high, const char* name)
{
  if (!value || (*value >= low && *value <= high)) return {};
  return Error{"%1 is %2; %3 to %4 is allowed.", name, std::to_string(*value), std::to_string(low),
               std::to_string(high)};
}

Result<void> within(const std::optional<Length>& value, const char* name)
{
  if (!value) return {};
  return within<double>(inMillimeters(*value), 0.0, inMillimeters(maxDepth), name);
}

}  // namespace

Result<void> checkSurgery(const Surgery& surgery)
{
  const auto isPlain = [](unsigned char c) { return std::isalnum(c) || c == '-'; };
  if (surgery.lot.size() > maxLot || !std::all_of(surgery.lot.begin(), surgery.lot.end(), isPlain))
    return Error{"The lot is “%1”; up to 24 letters, digits and hyphens are allowed.", surgery.lot};
  if (surgery.lubricant.size() > maxLubricant)
    return Error{"The lubricant has %1 characters; up to 40 are allowed.",
                 std::to_string(surgery.lubricant.size())};
  for (const auto& checked :
       {within(surgery.tilt_deg, -90.0, 90.0, "The tilt of the approach [degrees]"),
        within(surgery.turn_deg, -90.0, 90.0, "The turn of the approach [degrees]"),
        within(surgery.intendedDepth, "The intended depth [mm]"),
        within(surgery.outside, "The length outside [mm]"),
        within(surgery.intendedContacts, 0, maxContacts, "The number of contacts intended inside"),
        within(surgery.contactsOutside, 0, maxContacts, "The number of contacts outside"),
        within(surgery.contactAtResistance, 1, maxContacts, "The contact at first resistance"),
        within(surgery.attempts, 1, maxCount, "The number of attempts"),
        within(surgery.pullBacks, 0, maxCount, "The number of pull-backs"),
        within(surgery.daysToCt, 0, maxDays, "The days from surgery to CT")})
    if (!checked) return checked.error();
  return {};
}

}  // namespace perilymph::outcome
