#pragma once

// The two charts of forces: over travel, and over the last seconds.

#include <QObject>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/charts/ForceDepthChart.h"
#include "perilymph/charts/ForceTimeChart.h"
#include "perilymph/haptics/Snapshot.h"

class QVTKOpenGLNativeWidget;

namespace perilymph::gui {

class Pane;

/// Two charts, each in a pane of its own, so that one may be drawn without the other.
class ForceCharts : public QObject {
  Q_OBJECT
public:
  /// The panes become children of `parent`.
  explicit ForceCharts(QWidget* parent);
  ~ForceCharts() override;

  /// The published values drawn behind the curve; says why there are none otherwise.
  void setExperiment(const Result<charts::ReferenceCurve>& experiment);
  void setExperimentVisible(bool isVisible);
  /// An earlier run behind this one; an empty curve removes it.
  void setGhost(const std::vector<std::pair<Length, Force>>& curve, const QString& name);

  /// A new insertion: empties the curves, but not the ghost. Forces are split along the axes of
  /// `entry`.
  void begin(const anatomy::Entry& entry);
  /// Adds what one picture says to the curves.
  void append(const haptics::TickOutput& now);
  /// Renders the charts that changed and are seen. True if one did.
  bool renderIfDirty();

  Pane* overTravel() const { return travelPane_; }
  Pane* components() const { return timePane_; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QVTKOpenGLNativeWidget* chartView(QWidget* parent);

  // The charts before the panes' widgets are used: their renderers outlive no window.
  charts::ForceDepthChart overTravel_;
  charts::ForceTimeChart components_;
  QVTKOpenGLNativeWidget* travelView_;
  QVTKOpenGLNativeWidget* timeView_;
  Pane* travelPane_;
  Pane* timePane_;
  bool travelIsDirty_ = true, timeIsDirty_ = true;
  anatomy::Entry entry_;
};

}  // namespace perilymph::gui
