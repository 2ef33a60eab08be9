#pragma once

// Drawings of the engine and of the charts, painted by Qt.

#include <QPainter>

#include "perilymph/figures/Drawing.h"

namespace perilymph::gui {

/// How letters are set.
enum class Lettering {
  scaled,   ///< Set large and drawn small: they keep their places at every scale of the page.
  onScreen  ///< As the screen's own letters: sharp, and quick. For a painter that does not scale.
};

/// Paints the marks where the painter stands; a page point is its unit.
void paintMarks(QPainter& painter, const figures::Drawing& drawing, Lettering lettering);

}  // namespace perilymph::gui
