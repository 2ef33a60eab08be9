// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/Surgery.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "perilymph/session/Csv.h"

namespace perilymph::outcome {

namespace {

constexpr std::size_t maxLot = 24, maxLubricant = 40;
constexpr int maxContacts = 64, maxCount = 100, maxDays = 36'500;
constexpr int maxDepth_mm = 40;

/// @param field  As the window names it, so that the sentence leads there.
Result<void> within(Phrase field, const std::optional<int>& value, int low, int high)
{
  if (!value || (*value >= low && *value <= high)) return {};
  return Error{"%1 is %2; %3 to %4 is allowed.", Sentence(field), *value, low, high};
}

Result<void> within(Phrase field, const std::optional<double>& value_deg, int low_deg, int high_deg)
{
  if (!value_deg || (*value_deg >= low_deg && *value_deg <= high_deg)) return {};
  return Error{"%1 is %2°; %3° to %4° is allowed.", Sentence(field),
               session::shortestDecimal(*value_deg), low_deg, high_deg};
}

Result<void> within(Phrase field, const std::optional<Length>& value)
{
  if (!value || (*value >= millimeters(0.0) && *value <= millimeters(maxDepth_mm))) return {};
  return Error{"%1 is %2 mm; 0 to %3 mm is allowed.", Sentence(field),
               session::shortestDecimal(inMillimeters(*value)), maxDepth_mm};
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
       {within(Phrase{"Tilt of the approach"}, surgery.tilt_deg, -90, 90),
        within(Phrase{"Turn of the approach"}, surgery.turn_deg, -90, 90),
        within(Phrase{"Intended depth"}, surgery.intendedDepth),
        within(Phrase{"Length outside"}, surgery.outside),
        within(Phrase{"Contacts intended inside"}, surgery.intendedContacts, 0, maxContacts),
        within(Phrase{"Contacts outside"}, surgery.contactsOutside, 0, maxContacts),
        within(Phrase{"Contact at first resistance"}, surgery.contactAtResistance, 1, maxContacts),
        within(Phrase{"Attempts"}, surgery.attempts, 1, maxCount),
        within(Phrase{"Pull-backs"}, surgery.pullBacks, 0, maxCount),
        within(Phrase{"Days from surgery to CT"}, surgery.daysToCt, 0, maxDays)})
    if (!checked) return checked.error();
  return {};
}

Result<void> checkSurgery(const Surgery& surgery, const electrode::ArrayDesign& array)
{
  if (const auto done = checkSurgery(surgery); !done) return done;
  const auto count = static_cast<int>(array.contactsFromTip.size());
  for (const auto& [field, value] :
       {std::pair{Phrase{"Contacts intended inside"}, surgery.intendedContacts},
        std::pair{Phrase{"Contacts outside"}, surgery.contactsOutside},
        std::pair{Phrase{"Contact at first resistance"}, surgery.contactAtResistance}})
    if (value && *value > count)
      return Error{"%1 is %2, and %3 has %4 contacts. Correct the answer or choose the array.",
                   Sentence(field), *value, array.name, count};
  // a mark is read to half a millimeter (choice)
  const Length longest = array.insertable + millimeters(0.5);
  for (const auto& [field, value] : {std::pair{Phrase{"Intended depth"}, surgery.intendedDepth},
                                     std::pair{Phrase{"Length outside"}, surgery.outside}})
    if (value && *value > longest)
      return Error{"%1 is %2 mm, and %3 goes %4 mm deep. Correct the answer or choose the array.",
                   Sentence(field), session::shortestDecimal(inMillimeters(*value)), array.name,
                   session::shortestDecimal(inMillimeters(array.insertable))};
  return {};
}

}  // namespace perilymph::outcome
