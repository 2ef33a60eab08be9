// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/VisitorSession.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/text/Numbers.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

/// Smaller returns are tremor, not reversals.
constexpr double reversalTravel_m = 0.3e-3;

QString translated(const char* text) { return QCoreApplication::translate("VisitorSession", text); }

}  // namespace

void VisitorSession::follow(const haptics::Snapshot& snapshot)
{
  const haptics::TickOutput& now = snapshot.output;
  if (now.workflow == haptics::Workflow::idle || now.workflow == haptics::Workflow::armed) return;
  peakForce_ = snapshot.peak.force;
  deepestTravel_ = std::max(deepestTravel_, now.travel);
  duration_ = now.time;
  turning_ = isAdvancing_ ? std::max(turning_, now.travel) : std::min(turning_, now.travel);
  if (isAdvancing_ && now.travel < turning_ - reversalTravel_m) {
    ++reversals_;
    isAdvancing_ = false;
    turning_ = now.travel;
  } else if (!isAdvancing_ && now.travel > turning_ + reversalTravel_m) {
    isAdvancing_ = true;
    turning_ = now.travel;
  }
}

QString peakText(double peak_N, const Result<analysis::PrintedRange>& peaks)
{
  if (!peaks) return {};
  if (peak_N < peaks->low)
    return translated(
        QT_TRANSLATE_NOOP("VisitorSession", "Below the forces measured in patients."));
  if (peak_N > peaks->high)
    return translated(
        QT_TRANSLATE_NOOP("VisitorSession", "Above the forces measured in patients."));
  return translated(
      QT_TRANSLATE_NOOP("VisitorSession", "Within the range of forces measured in patients."));
}

QString peakSource(const Result<analysis::PrintedRange>& peaks)
{
  if (!peaks) return {};
  return translated(QT_TRANSLATE_NOOP("VisitorSession",
                                      "Peak forces measured in patients: %1–%2 mN (Rau et al. "
                                      "2024). This comparison is not a safety assessment."))
      .arg(numberText(inMillinewtons(newtons(peaks->low)), 0),
           numberText(inMillinewtons(newtons(peaks->high)), 0));
}

}  // namespace perilymph::gui
