// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Score.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace perilymph::analysis {

namespace {

// Reversals of hands asked to move slower than they can, at 15 mm/min (Kesler 2017).
constexpr double reversalsOfTooSlowHands = 18.6;
constexpr double restFractionOfTooSlowHands = 0.157;

// An array this near to its stop is there, as in the outcome of a report.
constexpr double nearStop = 0.5e-3;  // [m]

std::string fixed(double value, int decimals)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string percent(double fraction) { return fixed(100.0 * fraction, 0) + " %"; }

/// 1 at 0, 1/2 at `half`, 1/3 at twice that: the more, the less, without an end.
double fallingOff(double value, double half) { return half / (half + std::max(value, 0.0)); }

/// Travel of the array where it was farthest in, and its fraction of the stop travel.
ScoreCriterion insertionDone(const ComparedInsertion& insertion)
{
  const auto& curve = insertion.profile.curve;
  const double stop = insertion.stopTravel, done = curve.empty() ? 0.0 : curve.back().travel;
  const double fraction = done >= stop - nearStop ? 1.0 : std::max(done, 0.0) / stop;
  return {Sentence{"insertion"},
          stop <= 0.0 ? Sentence{"not known, because the scenario can no longer be read"}
                      : Sentence{"%1 of %2 mm", fixed(inMillimeters(meters(done)), 1),
                                 fixed(inMillimeters(meters(stop)), 1)},
          Sentence{"the score counts by this fraction"}, Sentence{"travel that the scenario sets"},
          fraction};
}

}  // namespace

std::string InsertionScore::sentence() const
{
  std::string text = fixed(total, 0) + " of 100:";
  for (std::size_t i = 0; i < criteria.size(); ++i)
    text += (i == 0 ? " " : ", ") + criteria[i].name + " " + percent(criteria[i].fraction);
  return text;
}

InsertionScore scoreOf(const ComparedInsertion& insertion, const PrintedRange& peakBand)
{
  const Motion& motion = insertion.motion;
  const double inBand = motion.wayIn > 0.0 ? motion.wayInBand / motion.wayIn : 0.0;
  const double bySpeed = motion.wayIn > 0.0 ? motion.wayBySpeed / motion.wayIn : 0.0;
  const double still = motion.time > 0.0 ? motion.timeStill / motion.time : 0.0;
  const double peak = insertion.arrayPeak.force;
  const double middle = 0.5 * (peakBand.low + peakBand.high);

  InsertionScore score;
  score.criteria = {
      {Sentence{"speed"},
       Sentence{"%1 % of the insertion at 0.1–2.0 mm/s", fixed(100.0 * inBand, 0)},
       Sentence{
           "full score within 0.1–2.0 mm/s, half at twice or half of these, in proportion beyond"},
       Sentence{"robotic insertion 0.1–1.0 mm/s (iotaSOFT); manual insertion in cadaver heads "
                "0.66 ± 0.31 mm/s; phantom study 0.1–2.0 mm/s (Froehlich et al. 2024)"},
       bySpeed},
      {Sentence{"reversals"}, Sentence{"%1 before maximum insertion depth", motion.reversals},
       Sentence{"full score at 0, half at 18.6"},
       Sentence{"Kesler et al. 2017: 18.6 reversals in manual insertions at a target of 15 "
                "mm/min"},
       fallingOff(motion.reversals, reversalsOfTooSlowHands)},
      {Sentence{"peak force"}, Sentence{"%1 mN", fixed(inMillinewtons(newtons(peak)), 1)},
       Sentence{"without ribs at the opening: full score at 0 mN, half at %1 mN, the middle of the "
                "peaks in patients",
                fixed(inMillinewtons(newtons(middle)), 1)},
       peakBand.source, fallingOff(peak, middle)},
      {Sentence{"smoothness"},
       Sentence{"%1 % of the time at rest (below 0.1 mm/s)", fixed(100.0 * still, 0)},
       Sentence{"full score at 0 %, half at 15.7 %"},
       Sentence{"Kesler et al. 2017: manual insertions at a target of 15 mm/min paused 15.7 % of "
                "the time"},
       fallingOff(still, restFractionOfTooSlowHands)}};
  const auto fraction = [&score](std::size_t index) { return score.criteria[index].fraction; };
  const double motionMean = std::cbrt(fraction(0) * fraction(1) * fraction(3));
  score.criteria.push_back(insertionDone(insertion));
  score.total = 100.0 * fraction(4) * fraction(2) * motionMean;
  return score;
}

Result<InsertionScore> scoreOf(const ComparedInsertion& insertion)
{
  const auto peaks = peaksInPatients();
  if (!peaks) return peaks.error();
  return scoreOf(insertion, *peaks);
}

}  // namespace perilymph::analysis
