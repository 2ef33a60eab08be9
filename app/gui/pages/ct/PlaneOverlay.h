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

/// Distance from its plane up to which a landmark is drawn [mm].
inline constexpr double markReach_mm = 1.0;

/// The color of a plane: of its name, and of its line in the other two pictures.
QColor colorOfPlane(std::size_t plane);

/// How clearly a contact is drawn in a plane: in the cochlear view all of the array's, in other planes
/// those near the plane; 0 if it is not drawn.
double contactOpacity(const CtStudy& study, std::size_t plane, const Eigen::Vector3d& contact_P);

/// Draws crosshair, outline of the measured wall, lines of A, B and H, line of approach, landmarks, marked
/// structures, contacts, letters of the
/// patient's directions, scale bar and name.
///
/// @param size     Of the picture; its center is the plane's center.
/// @param dragged  The landmark that is moved now.
void paintOverlay(QPainter& painter, const QSize& size, const CtStudy& study, std::size_t plane,
                  const std::optional<ct::Mark>& dragged);

}  // namespace perilymph::gui
