// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a person marks in a CT besides the landmarks of the cochlea: distances, angles, notes, and the
// structures of the approach.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::ct {

enum class MarkupKind {
  distance,       ///< Between two points.
  angle,          ///< Between two sides; the second of its three points is the vertex.
  note,           ///< A text at a point.
  facialNerve,    ///< Points along its vertical part; one or more.
  chordaTympani,  ///< Points along it; one or more.
  canalWall,      ///< Points on the posterior wall of the ear canal; one or more.
  approach,       ///< Line of approach: a point outside, then the center of the opening.
};

/// Their names in files.
inline constexpr std::array markupKinds{
    Choice<MarkupKind>{MarkupKind::distance, "distance"},
    Choice<MarkupKind>{MarkupKind::angle, "angle"},
    Choice<MarkupKind>{MarkupKind::note, "note"},
    Choice<MarkupKind>{MarkupKind::facialNerve, "facial_nerve"},
    Choice<MarkupKind>{MarkupKind::chordaTympani, "chorda_tympani"},
    Choice<MarkupKind>{MarkupKind::canalWall, "canal_wall"},
    Choice<MarkupKind>{MarkupKind::approach, "approach"}};

/// The structures of the approach, whose distances from the line of approach are shown.
inline constexpr std::array approachStructures{MarkupKind::facialNerve, MarkupKind::chordaTympani,
                                               MarkupKind::canalWall};

/// Limits of the markups of a CT [entries, points, bytes of UTF-8].
inline constexpr std::size_t maxMarkups = 200, maxMarkupPoints = 100, maxMarkupText = 400;

struct Markup {
  MarkupKind kind = MarkupKind::distance;
  /// In P [mm], as many as the kind has.
  std::vector<Eigen::Vector3d> points_P = {};
  /// Words of the person who placed it; a note has some. They may tell of a patient: never in a log, an
  /// error or the name of a file.
  std::string text = {};

  friend bool operator==(const Markup&, const Markup&) = default;
};

/// The markups of one CT series.
struct CtMarkups {
  std::string seriesKey;  ///< SHA-256 of the series, hexadecimal.
  /// Edges of its voxels along i, j, k in P, as columns [mm].
  Eigen::Matrix3d voxelEdges_P = Eigen::Matrix3d::Identity();
  std::vector<Markup> markups = {};

  friend bool operator==(const CtMarkups&, const CtMarkups&) = default;
};

/// No markups of a volume yet.
CtMarkups markupsOf(const CtVolume& volume);

/// How many points a kind has.
struct PointCount {
  std::size_t least, most;
};
PointCount pointCountOf(MarkupKind kind);

/// Unit of the value of a kind in files: "deg" of an angle, else "mm".
constexpr const char* unitOf(MarkupKind kind) { return kind == MarkupKind::angle ? "deg" : "mm"; }

/// Refuses a markup with another number of points than its kind has, a point that is not finite or beyond
/// 10 m, two points of a distance or of a side of an angle at one place, a note without text, and a text with
/// control characters, invalid UTF-8 or more than maxMarkupText bytes. The message has no text of it.
Result<void> checkMarkup(const Markup& markup);

/// The same for all of a series, with its key and its voxels, whose edges are 1 micrometer to 100 mm long.
Result<void> checkMarkups(const CtMarkups& markups);

/// A value between points with the standard deviation of its error from placing them.
struct MarkupValue {
  double value = 0.0, sd = 0.0;
};

/// The length of a distance [mm] or the size of an angle [degrees, 0 to 180]; empty for other kinds and for
/// another number of points.
///
/// The error is that of placing each point to its voxel: independent and uniform within half an edge along
/// i, j and k, and the value's differential. With E of the edges as columns the covariance of a point is
/// E Eᵀ/12, and for points p, q and the vertex v
///
///     distance   n = (q − p)/|q − p|                        sd = |Eᵀn|/√6
///     angle      g_p = −m_p/|p − v|, g_q = −m_q/|q − v|      sd² = (|Eᵀg_p|² + |Eᵀg_q|² + |Eᵀ(g_p + g_q)|²)/12
///
/// where m_p is the unit vector across the side to p, toward the other side. Where the sides are one line,
/// m is the direction across it with the largest error. For voxels of the edge h the distance has h/√6 = 0.41 h.
/// Blur, motion, scale of the scanner and what a person takes for the edge of a structure are left out.
std::optional<MarkupValue> valueOf(const Markup& markup, const Eigen::Matrix3d& voxelEdges_P);

/// A sentence if points lie outside the volume, where nothing of them is shown; else none.
std::optional<Sentence> outsideNote(const CtMarkups& markups, const CtVolume& volume);

}  // namespace perilymph::ct
