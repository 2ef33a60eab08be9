// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a plan expects of one array in one patient's cochlea.

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// Shown behind insertions of this array into this cochlea.
struct PlannedForce {
  /// The axial force at a depth of the tip past the opening.
  struct Point {
    double depth_mm = 0.0, low_mN = 0.0, median_mN = 0.0, high_mN = 0.0;
  };
  QString name;    ///< "plan of 2026-11-27", the day on which it was made.
  QString number;  ///< First 16 digits of its fingerprint, as in the report of the plan.
  QString label;
  QString
      hold;  ///< What the bands hold and what they hold fixed: "90 % over friction 0.08 to 0.33".
  planning::Band peak_mN, end_mN, angle_deg;
  std::optional<planning::Band> after1s_mN;  ///< Empty in plans of versions without it.
  anatomy::Patient patient;
  anatomy::Approach approach;
  std::string array;  ///< As in a scenario.
  std::vector<Point> points;

  /// Whether a scenario inserts this array into this cochlea, along this line of approach.
  bool isFor(const session::Scenario& scenario) const;
};

}  // namespace perilymph::gui
