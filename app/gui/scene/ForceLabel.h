#pragma once

// What the forces mean, drawn under the number of the force.

#include <QWidget>

#include "gui/scene/ForceInterpretation.h"

namespace perilymph::gui {

/// Both on two lines, on a plate so that the picture may pass behind them. What stands out has a
/// mark before it besides its color.
class ForceLabel : public QWidget {
  Q_OBJECT
public:
  explicit ForceLabel(QWidget* parent);

  void show(Force onHand, Force onPartition);
  const QString& handText() const { return hand_.text; }
  const QString& partitionText() const { return partition_.text; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  ForceThresholds known_;
  ForceMeaning hand_, partition_;
};

}  // namespace perilymph::gui
