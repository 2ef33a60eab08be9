#pragma once

// An insertion as a small picture: the scala tympani from the side of the surgeon, and the array.

#include <QPainter>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// What a picture is made of.
struct PicturedInsertion {
  const anatomy::ScalaTympani& scala;
  const electrode::ArrayDesign& array;
  anatomy::Side side = anatomy::Side::right;
  /// The array; without it the scala alone is drawn.
  const haptics::Snapshot* now = nullptr;
};

/// The inks of a picture.
struct PictureInks {
  QColor wall, lumen, array, contact;
};
PictureInks screenInks();
PictureInks printInks();

/// Paints it into a place, to scale and whole, the opening at the upper left. In any thread.
void paintInsertion(QPainter& painter, const QRectF& place, const PicturedInsertion& pictured,
                    const PictureInks& inks);

}  // namespace perilymph::gui
