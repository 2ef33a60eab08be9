// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Comparison of recorded insertions.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/InsertionEvents.h"
#include "perilymph/analysis/MotionCounter.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::analysis {

/// The quantity over which forces are compared.
enum class CurveAxis : std::uint8_t {
  travel,  ///< Depth minus depth at the start.
  depth,   ///< Depth of the tip past the opening.
  angle    ///< Angle of the tip from the round window.
};

/// A point of a curve over an axis.
struct AxisPoint {
  double place = 0.0;  ///< [m] or [rad]
  double force = 0.0;  ///< Axial, on the hand [N].
};

/// Spacing of the points over an axis [m or rad]: 0.1 mm, 1 degree.
double stepOf(CurveAxis axis);

/// A place on an axis as it is shown: mm or degrees.
double shownPlace(CurveAxis axis, double place);

/// What was set for an insertion beside array, technique and patient. Empty or 0 where the scenario can no
/// longer be read.
struct InsertionSettings {
  std::string friction;         ///< Its name: "estimate-from-pig-tissue"; "own" if in no file.
  std::string coefficient;      ///< Static: "0.165"; by speed "0.12 to 0.3".
  std::optional<double> speed;  ///< Set for the script [m/s]; empty of an insertion by hand.
  std::string opening;          ///< "round-window".
  double approachTilt = 0.0, approachTurn = 0.0;  ///< [rad]
  double stopForce = 0.0;                         ///< [N]; 0 without.
  std::uint64_t seed = 0;
};

/// Data of one recording.
struct ComparedInsertion {
  std::string name;       ///< Name for display, see session::displayNameOf().
  std::string recording;  ///< Name of the file.
  std::string scenario;
  session::ScenarioSubject subject;
  InsertionSettings settings;
  haptics::InsertionEnd end = haptics::InsertionEnd::none;
  std::string startedUtc;  ///< "2010-05-17T09:30:00Z".
  ForceProfile profile;
  /// The force at each multiple of stepOf() that depth and angle first pass.
  std::vector<AxisPoint> overDepth, overAngle;
  ForceAtDepth arrayPeak;               ///< With no marker rib at the opening.
  std::optional<ForceAtDepth> ribPeak;  ///< With one there; empty if none came there.
  int ribNumber = 0;                    ///< Rib of ribPeak, from the tip: 1, 2, ...
  std::vector<InsertionEvent> events;   ///< In the order of time.
  int reversals = 0;                    ///< Over the whole insertion.
  Motion motion;                        ///< Up to the maximum depth.
  /// Travel that the scenario sets as the goal [m]; 0 if the scenario can no longer be read.
  double stopTravel = 0.0;
  /// The rupture of the cochlear partition, with the most of the array that was above it at a time;
  /// empty if the partition held.
  std::optional<haptics::Translocation> translocation;
  bool hasPublishedConditions = false;  ///< Comparable with the published measurements.
  session::RecordingCheck check;        ///< Whether the file is as it was recorded.
};

/// The name, with " (changed by hand)" if the file is not as it was recorded.
std::string labelOf(const ComparedInsertion& insertion);

/// Reads a whole recording and checks its seal. `stop` ends it early, with an error.
Result<ComparedInsertion> readCompared(const std::filesystem::path& file,
                                       const std::stop_token& stop = {});

/// The force over an axis, in ascending order of places.
std::vector<AxisPoint> curveOver(const ComparedInsertion& insertion, CurveAxis axis);

/// `name, scenario, peak_N, peak_travel_mm, peak_depth_mm, work_mJ, reversals, duration_s,
/// final_depth_mm, final_angle_deg, rupture_angle_deg, rupture_N, above_mm, array, technique, patient,
/// side, array_peak_N, array_peak_depth_mm, rib_peak_N, rib_peak_depth_mm, end_N, deepest_angle_deg,
/// score, score_definition, mean_speed_mm_s, recording, friction, friction_coefficient, speed_set_mm_s,
/// opening, approach_tilt_deg, approach_turn_deg, seed, stop_travel_mm, stop_force_N, end`, one row per
/// recording. Those of a rupture are empty if the partition held, those of a rib if none came to the opening.
std::string comparisonCsv(const std::vector<ComparedInsertion>& insertions);

/// `column, unit, meaning`, one row per column of comparisonCsv().
std::string comparisonDictionaryCsv();

/// `travel_mm`, `depth_mm` or `angle_deg` and a column `<name>_N` per recording, every stepOf(); empty
/// where it has no point.
std::string curvesCsv(const std::vector<ComparedInsertion>& insertions,
                      CurveAxis axis = CurveAxis::travel);

/// `name, event, rib, time_s, travel_mm, depth_mm, angle_deg, force_N`, one row per event.
std::string eventsCsv(const std::vector<ComparedInsertion>& insertions);

/// Whether all have the same array and one of them has the conditions of the published measurements;
/// else these are not drawn.
bool areComparableWithPublished(const std::vector<ComparedInsertion>& insertions);

/// The force of a curve at a place [m or rad], linearly interpolated; empty outside its range.
std::optional<double> forceAt(const std::vector<AxisPoint>& curve, double place);

/// Appends a number to insertions with equal labels, which would share a column, until none are equal.
void tellApart(std::vector<ComparedInsertion>& insertions);

}  // namespace perilymph::analysis
