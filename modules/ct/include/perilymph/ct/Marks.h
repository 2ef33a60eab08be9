// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Landmarks of a cochlea that a person places, and the measures they give.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Sentence.h"

namespace perilymph::ct {

struct CochleaMeasures;

/// The landmarks. A runs from the round window to the far wall, B from near to far, H from the floor
/// of the basal turn to the apex.
enum class Mark { roundWindow, farWall, nearB, farB, floor, apex, modiolus };
inline constexpr std::size_t markCount = 7;

/// Name of a landmark as in files, with those of the published ears where they exist: "RW", "OW",
/// "B1", "B2", "H", "A", "C".
const char* nameOf(Mark mark);
/// The landmark with a name in a file, or by its clinical one ("LW", "base", "apex", "M"); empty for
/// other names.
std::optional<Mark> markNamed(const std::string& name);

/// A measure between two landmarks.
struct MeasureLine {
  const char* name;  ///< "A", "B" or "H".
  Mark from, to;
};
inline constexpr std::array<MeasureLine, 3> measureLines{{{"A", Mark::roundWindow, Mark::farWall},
                                                          {"B", Mark::nearB, Mark::farB},
                                                          {"H", Mark::floor, Mark::apex}}};

/// Positions in P [mm]; empty where not placed.
struct Marks {
  std::array<std::optional<Eigen::Vector3d>, markCount> points_P;

  std::optional<Eigen::Vector3d>& operator[](Mark mark)
  {
    return points_P[static_cast<std::size_t>(mark)];
  }
  const std::optional<Eigen::Vector3d>& operator[](Mark mark) const
  {
    return points_P[static_cast<std::size_t>(mark)];
  }
  bool isEmpty() const;
  bool operator==(const Marks& other) const;

  /// A point in the cochlea to start a fit from; empty without a landmark of the cochlea's inside.
  std::optional<Eigen::Vector3d> inside_P() const;
};

/// The landmarks of a fitted cochlea, on its wall: where A, B and H end.
Marks marksOf(const CochleaMeasures& measures);

/// Measures between landmarks [mm]; empty where an end is missing.
struct MarkedMeasures {
  std::optional<double> a, b, h;
};

/// Measures between landmarks: A and B across the axis, H along it.
///
/// @param axis_P  The modiolar axis, unit. Without it the line from modiolus to apex is used, and
///                straight distances without that.
MarkedMeasures measuresBetween(const Marks& marks, const std::optional<Eigen::Vector3d>& axis_P);

/// A sentence for each of A, B and H that lies, between landmarks of which a person placed one or
/// both, outside the 95 % interval of the fitted one.
std::vector<Sentence> landmarkContradictions(const CochleaMeasures& measures);

}  // namespace perilymph::ct
