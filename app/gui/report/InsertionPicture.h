// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Thumbnail of an insertion: the scala tympani from the surgeon's side, and the array.

#include <QPainter>

#include "gui/report/ScalaProjection.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// Content of a thumbnail.
struct PicturedInsertion {
  const anatomy::ScalaTympani& scala;
  const electrode::ArrayDesign& array;
  anatomy::Side side = anatomy::Side::right;
  /// The array; if null, only the scala is drawn.
  const haptics::Snapshot* now = nullptr;
};

/// Colors of a thumbnail.
struct PictureInks {
  QColor wall, lumen, array, contact;
};
PictureInks screenInks();
PictureInks printInks();

/// Paints it into a rectangle, to scale, the opening at the upper left. Any thread.
void paintInsertion(QPainter& painter, const QRectF& place, const PicturedInsertion& pictured,
                    const PictureInks& inks);
/// The same in the projection's millimeters, for a painter that maps them to its device.
void paintProjected(QPainter& painter, const ScalaProjection& plane,
                    const PicturedInsertion& pictured, const PictureInks& inks);

}  // namespace perilymph::gui
