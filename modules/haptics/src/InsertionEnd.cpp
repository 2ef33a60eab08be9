// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/InsertionEnd.h"

#include "perilymph/foundation/Sentence.h"

namespace perilymph::haptics {

namespace {

struct Entry {
  InsertionEnd end;
  const char* name;
  Phrase clause;
};

constexpr std::array<Entry, 9> table = {
    {{InsertionEnd::none, "none", Phrase{"has not ended"}},
     {InsertionEnd::finished, "finished", Phrase{"reached its full travel"}},
     {InsertionEnd::stoppedByResistance, "stopped_by_resistance",
      Phrase{"was stopped because the force reached the limit"}},
     {InsertionEnd::buckled, "buckled", Phrase{"buckled in front of the opening"}},
     {InsertionEnd::outOfOpening, "out_of_opening",
      Phrase{"bowed in front of the opening and slipped out of it"}},
     {InsertionEnd::foldedTip, "folded_tip", Phrase{"folded over at its tip"}},
     {InsertionEnd::jammed, "jammed", Phrase{"jammed"}},
     {InsertionEnd::fault, "fault", Phrase{"stopped with a fault"}},
     {InsertionEnd::refused, "refused", Phrase{"was refused"}}}};

const Entry& entryOf(InsertionEnd end) noexcept
{
  for (const Entry& entry : table)
    if (entry.end == end) return entry;
  return table.front();
}

}  // namespace

std::uint32_t bitOf(InsertionEnd end) noexcept
{
  for (const auto& [event, bit] : endEvents)
    if (event == end) return bit;
  return 0;
}

InsertionEnd endOf(const TickOutput& now) noexcept
{
  for (const auto& [event, bit] : endEvents)
    if ((now.status & bit) != 0) return event;
  if (now.workflow == Workflow::fault) return InsertionEnd::fault;
  return now.workflow == Workflow::finished ? InsertionEnd::finished : InsertionEnd::none;
}

const char* nameOf(InsertionEnd end) noexcept { return entryOf(end).name; }

InsertionEnd endNamed(const std::string& name) noexcept
{
  if (name == "slipped out") return InsertionEnd::outOfOpening;
  for (const Entry& entry : table)
    if (name == entry.name) return entry.end;
  return InsertionEnd::none;
}

const char* clauseOf(InsertionEnd end) noexcept { return entryOf(end).clause.english(); }

}  // namespace perilymph::haptics
