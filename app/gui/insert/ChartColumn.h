#pragma once

// The column at the right: force over travel, and the force's components.

#include <QWidget>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/charts/ForceDepthChart.h"
#include "perilymph/charts/ForceTimeChart.h"
#include "perilymph/haptics/Snapshot.h"

class QLabel;
class QVBoxLayout;
class QVTKOpenGLNativeWidget;

namespace perilymph::gui {

/// Two charts, each in a view of its own, so that one may be drawn without the other.
class ChartColumn : public QWidget {
  Q_OBJECT
public:
  explicit ChartColumn(QWidget* parent);
  ~ChartColumn() override;

  /// The published values drawn behind the curve; says why there are none otherwise.
  void setExperiment(const Result<charts::ReferenceCurve>& experiment);
  void setExperimentVisible(bool isVisible);
  /// Another insertion behind this one, until the next call; an empty curve removes it.
  void setGhost(std::vector<std::pair<Length, Force>> curve, const QString& name);

  /// A new insertion: empties the curves. Forces are split along the axes of `entry`.
  void begin(const anatomy::Entry& entry);
  /// Adds what one picture says to the curves.
  void append(const haptics::TickOutput& now);
  /// Renders the charts that changed. True if one did.
  bool renderIfDirty();

private:
  QVTKOpenGLNativeWidget* addChart(QVBoxLayout& column, const QString& title, const QString& note,
                                   int stretch);

  // The charts before the widgets: their renderers outlive no window.
  charts::ForceDepthChart overTravel_;
  charts::ForceTimeChart components_;
  QVTKOpenGLNativeWidget* travelView_;
  QVTKOpenGLNativeWidget* timeView_;
  QLabel* travelTitle_ = nullptr;
  anatomy::Entry entry_;
};

}  // namespace perilymph::gui
