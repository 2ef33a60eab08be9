// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where labels of points stand in a picture.

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace perilymph::gui {

/// A label and the point that it names [px].
struct LabelledPoint {
  QPointF at;
  QSizeF size;
};

/// Rectangles for labels, in their order: inside the pane, none on another, on a taken place or on a
/// point, each as near to its point as that allows; leader lines cross neither each other nor labels
/// where there is room for that. Null where the pane has no room for a label.
std::vector<QRectF> placeLabels(const std::vector<LabelledPoint>& labels, const QRectF& pane,
                                const std::vector<QRectF>& taken = {});

/// The line from a point to its label; null if the label is beside it.
QLineF leaderLine(const QPointF& point, const QRectF& label);

}  // namespace perilymph::gui
