// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is drawn over a plane of the CT.

#include <QColor>
#include <cstddef>
#include <optional>

#include "gui/pages/ct/CtStudy.h"

class QPainter;
class QSize;

namespace perilymph::gui {

/// Distance from its plane up to which a landmark or a markup is drawn [mm].
inline constexpr double markReach_mm = 1.0;

/// The color of a plane: of its name, and of its line in the other two pictures.
QColor colorOfPlane(std::size_t plane);

/// How clearly a contact is drawn in a plane: in the cochlear view all of the array's, in other planes
/// those near the plane; 0 if it is not drawn.
double contactOpacity(const CtStudy& study, std::size_t plane, const Eigen::Vector3d& contact_P);

/// How clearly a markup is drawn in a plane: less the farther its nearest point or line is, not drawn beyond
/// markReach_mm; 0 if it is not drawn. All of it is drawn as it is projected onto the plane.
double markupOpacity(const CtStudy& study, std::size_t plane, const ct::Markup& markup);

/// What is drawn over a plane besides the study.
struct OverlayState {
  std::optional<ct::Mark> dragged = {};  ///< The landmark that is moved now.
  std::optional<Eigen::Vector3d> cursor =
      {};  ///< Point under the mouse, in P [mm]: its value is written.
  bool hasCrosshair = true;
};

/// Draws crosshair, outline of the measured wall, lines of A, B and H, line of approach, landmarks, contacts, markups,
/// letters of the patient's directions, scale bar and name. No label covers another one.
///
/// @param size  Of the picture; its center is the plane's center.
void paintOverlay(QPainter& painter, const QSize& size, const CtStudy& study, std::size_t plane,
                  double pixel_mm, const OverlayState& state);

}  // namespace perilymph::gui
