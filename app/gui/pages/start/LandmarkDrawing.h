// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Drawing of the landmarks that a patient's measures refer to.

#include <QWidget>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

/// The cochlear view with A and B, and the view perpendicular to it with H. The spiral is that of
/// the typed A and B (Pietsch et al. 2017), to scale; a left ear is the mirror image.
class LandmarkDrawing : public QWidget {
  Q_OBJECT
public:
  enum class Landmark { none, a, b, h };

  explicit LandmarkDrawing(QWidget* parent);

  void show(const anatomy::BasalTurn& turn, anatomy::Side side);
  /// Emphasizes what the field with the focus asks for.
  void emphasize(Landmark landmark);

  QSize sizeHint() const override { return {400, 250}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  void paintCochlearView(QPainter& painter, const QRectF& place) const;
  void paintSideView(QPainter& painter, const QRectF& place) const;
  QPen penOf(Landmark landmark) const;

  anatomy::BasalTurn turn_;
  anatomy::Side side_ = anatomy::Side::right;
  Landmark emphasized_ = Landmark::none;
};

}  // namespace perilymph::gui
