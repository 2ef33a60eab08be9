// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Paints drawings of the engine and of the charts with Qt.

#include <QPainter>

#include "perilymph/figures/Drawing.h"

namespace perilymph::gui {

/// Text rendering mode.
enum class Lettering {
  scaled,   ///< Laid out at a large size and scaled down: positions are the same at every scale of
            ///< the page.
  onScreen  ///< At screen resolution: sharp and fast. For a painter without scaling.
};

/// Background of the drawing.
enum class Sheet {
  white,  ///< Inks as they are printed.
  dark    ///< Inks of the same hue with the opposite lightness.
};

/// Paints the marks in the painter's coordinates; the unit is a page point.
///
/// @param textFactor  Size of the text relative to the drawing's.
void paintMarks(QPainter& painter, const figures::Drawing& drawing, Lettering lettering,
                Sheet sheet = Sheet::white, double textFactor = 1.0);

}  // namespace perilymph::gui
