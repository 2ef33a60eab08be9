// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The phase of the insertion as four stations on a line.

#include <QWidget>

#include "perilymph/analysis/Phase.h"

namespace perilymph::gui {

/// Opening, outer wall, basal turn, full depth: passed stations are filled, the current one is
/// large with a bold name.
class PhaseLine : public QWidget {
  Q_OBJECT
public:
  explicit PhaseLine(QWidget* parent);

  void setPhase(analysis::Phase phase);
  analysis::Phase phase() const { return phase_; }
  /// Names the last station: full depth, or the stop of a partial insertion.
  void setPartial(bool isPartial);
  /// Names for visitors of a booth, where there is room in a size [px, before textScale()]: the last
  /// station of a partial insertion is their goal.
  void setForVisitors(int size_px);
  /// Explanation of the station at a place of this widget; empty between them.
  QString tipAt(const QPoint& place) const;
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  QString nameOf(analysis::Phase phase) const;
  /// A length at the usual size of the names, at the chosen one [px].
  int lengthOf(int usual_px) const;
  int nameHeight() const;
  bool areNamesWhole(int available_px) const;

  analysis::Phase phase_ = analysis::Phase::outside;
  bool isPartial_ = false;
  bool isForVisitors_ = false;
  int name_px_;
};

}  // namespace perilymph::gui
