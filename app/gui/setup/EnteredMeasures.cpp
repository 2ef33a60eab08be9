// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/EnteredMeasures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "perilymph/analysis/ErrorBand.h"

namespace perilymph::gui {

namespace {

constexpr const char* enteredMark = "; entered: ";
constexpr double shown_mm = 0.006;  // fields show hundredths of a millimeter

using Values = std::array<std::optional<Length>, 3>;

Values valuesOf(const anatomy::BasalTurn& turn) { return {turn.a, turn.b, turn.h}; }

bool isSame(const std::optional<Length>& one, const std::optional<Length>& other)
{
  if (!one || !other) return one.has_value() == other.has_value();
  return std::fabs(inMillimeters(*one - *other)) < shown_mm;
}

/// The errors, with that of each replaced measure as assumed, which no other error goes with.
anatomy::BasalTurnErrors errorsAfter(anatomy::BasalTurnErrors errors,
                                     const std::array<bool, 3>& isReplaced)
{
  if (isReplaced[0]) errors.a = analysis::measuringError;
  if (isReplaced[1]) errors.b = analysis::measuringError;
  if (isReplaced[2]) errors.h.reset();
  if (isReplaced[0] || isReplaced[1]) errors.ab = 0.0;
  if (isReplaced[0] || isReplaced[2]) errors.ah = 0.0;
  if (isReplaced[1] || isReplaced[2]) errors.bh = 0.0;
  return errors;
}

}  // namespace

std::vector<std::string> enteredMeasures(const anatomy::Patient& patient)
{
  const std::string& software = patient.origin.software;
  const std::size_t mark = software.rfind(enteredMark);
  std::vector<std::string> found;
  if (mark == std::string::npos) return found;
  const std::string names = software.substr(mark + std::string(enteredMark).size());
  for (const char* name : {"A", "B", "H"})
    if (names.find(name) != std::string::npos) found.emplace_back(name);
  return found;
}

bool isEntered(const anatomy::Patient& patient, const std::string& measure)
{
  const std::vector<std::string> entered = enteredMeasures(patient);
  return std::ranges::find(entered, measure) != entered.end();
}

anatomy::Patient withMeasuresOf(const anatomy::Patient& known, anatomy::Patient entered)
{
  if (!known.basalTurn || !entered.basalTurn) return entered;
  const Values before = valuesOf(*known.basalTurn), now = valuesOf(*entered.basalTurn);
  constexpr std::array names{"A", "B", "H"};
  std::array<bool, 3> isReplaced{};
  bool isAnyKept = false;
  std::string list;
  for (std::size_t k = 0; k < names.size(); ++k) {
    isReplaced[k] = !isSame(before[k], now[k]);
    const bool isOfPerson = isReplaced[k] || isEntered(known, names[k]);
    isAnyKept = isAnyKept || (now[k] && !isOfPerson);
    if (now[k] && isOfPerson) list += (list.empty() ? "" : ", ") + std::string(names[k]);
  }
  entered.errors.reset();
  entered.origin = {};
  if (!isAnyKept) return entered;
  if (known.errors) entered.errors = errorsAfter(*known.errors, isReplaced);
  entered.origin = known.origin;
  const bool isWhole = std::ranges::none_of(isReplaced, [](bool each) { return each; });
  if (isWhole || anatomy::isFromCt(known) || known.seal == Seal::changed) entered.seal = known.seal;
  std::string& software = entered.origin.software;
  software.resize(std::min(software.size(), software.rfind(enteredMark)));
  if (!list.empty() && !software.empty()) software += enteredMark + list;
  return entered;
}

}  // namespace perilymph::gui
