// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/InsertionEvents.h"

#include <algorithm>
#include <cmath>

#include "perilymph/haptics/InsertionEnd.h"

namespace perilymph::analysis {

namespace {

std::vector<double> ribsOf(const electrode::ArrayDesign& array)
{
  std::vector<double> ribs;
  for (const Length rib : array.ribsFromTip) ribs.push_back(rib.si());
  std::ranges::sort(ribs);
  return ribs;
}

EventKind kindOf(haptics::InsertionEnd end)
{
  switch (end) {
    case haptics::InsertionEnd::stoppedByResistance:
      return EventKind::resistance;
    case haptics::InsertionEnd::buckled:
      return EventKind::buckled;
    case haptics::InsertionEnd::outOfOpening:
      return EventKind::outOfOpening;
    case haptics::InsertionEnd::foldedTip:
      return EventKind::foldedTip;
    case haptics::InsertionEnd::jammed:
      return EventKind::jammed;
    default:
      return EventKind::end;
  }
}

}  // namespace

const char* nameOf(EventKind kind)
{
  switch (kind) {
    case EventKind::firstResistance:
      return "first_resistance";
    case EventKind::ribAtOpening:
      return "rib_at_opening";
    case EventKind::styletWithdrawal:
      return "stylet_withdrawal";
    case EventKind::rupture:
      return "rupture";
    case EventKind::translocation:
      return "translocation";
    case EventKind::peak:
      return "peak";
    case EventKind::resistance:
      return "stopped_by_resistance";
    case EventKind::buckled:
      return "buckled";
    case EventKind::outOfOpening:
      return "out_of_opening";
    case EventKind::foldedTip:
      return "folded_tip";
    case EventKind::jammed:
      return "jammed";
    case EventKind::end:
      return "end";
    case EventKind::withdrawal:
      return "withdrawal";
  }
  return "";
}

Sentence textOf(const InsertionEvent& event)
{
  switch (event.kind) {
    case EventKind::firstResistance:
      return Sentence{"first palpable resistance"};
    case EventKind::ribAtOpening:
      return Sentence{"rib %1 at the opening", event.number};
    case EventKind::styletWithdrawal:
      return Sentence{"stylet withdrawal begins"};
    case EventKind::rupture:
      return Sentence{"rupture of the partition"};
    case EventKind::translocation:
      return Sentence{"translocation"};
    case EventKind::peak:
      return Sentence{"peak insertion force"};
    case EventKind::resistance:
      return Sentence{"stopped by resistance"};
    case EventKind::buckled:
      return Sentence{"buckled in front of the opening"};
    case EventKind::outOfOpening:
      return Sentence{"out of the opening"};
    case EventKind::foldedTip:
      return Sentence{"tip fold-over"};
    case EventKind::jammed:
      return Sentence{"jammed"};
    case EventKind::end:
      return Sentence{"end of the insertion"};
    case EventKind::withdrawal:
      return Sentence{"withdrawal begins"};
  }
  return {};
}

EventFinder::EventFinder(const electrode::ArrayDesign& array, double felt)
    : ribs_(ribsOf(array)), felt_(felt)
{
}

void EventFinder::note(EventKind kind, std::uint64_t place, const haptics::TickOutput& now,
                       int number)
{
  events_.push_back(
      {kind, number, place, now.time, now.travel, now.depth, now.angularDepth, now.axialForce});
}

void EventFinder::add(std::uint64_t place, const haptics::TickOutput& now,
                      const haptics::PeakForce& peak)
{
  if (now.workflow == haptics::Workflow::idle || now.workflow == haptics::Workflow::armed) {
    before_.reset();
    return;
  }
  const auto begins = [&](std::uint32_t bit) {
    return (now.status & bit) != 0 && (!before_ || (before_->status & bit) == 0);
  };
  if (peak.force > (peak_ ? peak_->force : 0.0))
    peak_ = InsertionEvent{EventKind::peak,  0,         place, now.time, peak.travel, now.depth,
                           now.angularDepth, peak.force};
  if (felt_ > 0.0 && !hasResistance_ && peak.force >= felt_) {
    hasResistance_ = true;
    note(EventKind::firstResistance, place, now);
  }
  while (nextRib_ < ribs_.size() && now.depth >= ribs_[nextRib_])
    note(EventKind::ribAtOpening, place, now, static_cast<int>(++nextRib_));
  if (now.styletWithdrawal > 0.0 && before_ && before_->styletWithdrawal == 0.0)
    note(EventKind::styletWithdrawal, place, now);
  if (begins(haptics::partitionRuptured)) note(EventKind::rupture, place, now);
  if (begins(haptics::translocated) &&
      std::ranges::none_of(events_, [](const InsertionEvent& each) {
        return each.kind == EventKind::translocation;
      }))
    note(EventKind::translocation, place, now);
  if (now.workflow == haptics::Workflow::finished && !hasEnded_) {
    hasEnded_ = true;
    note(kindOf(haptics::endOf(now)), place, now);
  }
  if (hasEnded_ && !isWithdrawn_ && now.workflow == haptics::Workflow::inserting) {
    isWithdrawn_ = true;
    note(EventKind::withdrawal, place, now);
  }
  before_ = now;
}

std::vector<InsertionEvent> EventFinder::events() const
{
  std::vector<InsertionEvent> sorted = events_;
  if (peak_) sorted.push_back(*peak_);
  std::ranges::stable_sort(sorted, {}, &InsertionEvent::place);
  return sorted;
}

RibPeaks::RibPeaks(const electrode::ArrayDesign& array, Length passage)
    : ribs_(ribsOf(array)), passage_(passage.si())
{
}

void RibPeaks::add(const haptics::TickOutput& now)
{
  const ForceAtDepth here{now.axialForce, now.travel, now.depth, now.angularDepth};
  const double reach = ribReach().si();
  const auto rib = std::ranges::find_if(ribs_, [&](double place) {
    return now.depth >= place - reach && now.depth <= place + passage_ + reach;
  });
  if (rib == ribs_.end()) {
    if (haptics::raisesPeak(now, array_.force)) array_ = here;
    return;
  }
  if (!haptics::raisesPeak(now, rib_ ? rib_->force : 0.0)) return;
  rib_ = here;
  ribNumber_ = static_cast<int>(rib - ribs_.begin()) + 1;
}

}  // namespace perilymph::analysis
