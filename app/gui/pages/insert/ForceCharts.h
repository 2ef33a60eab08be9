// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The two force charts: over travel, and over the last seconds.

#include <QObject>
#include <optional>

#include "gui/run/PlannedForce.h"
#include "gui/run/ReferenceInsertion.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/anatomy/Lumen.h"
#include "perilymph/charts/ForceDepthChart.h"
#include "perilymph/charts/ForceTimeChart.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

class Pane;
class PlainVtkWidget;

/// Two charts, each in its own pane, so that they are rendered independently.
class ForceCharts : public QObject {
  Q_OBJECT
public:
  /// The panes become children of `parent`.
  explicit ForceCharts(QWidget* parent);
  ~ForceCharts() override;

  /// Sets the published values drawn behind the curve, or shows why there are none.
  void setExperiment(const Result<charts::ReferenceCurve>& experiment);
  void setExperimentVisible(bool isVisible);
  /// Whether the insertion has the conditions of the experiment; its values are hidden otherwise.
  void setComparable(bool isComparable);
  /// Sets an earlier run drawn behind this one; an empty curve removes it.
  void setGhost(const std::optional<ReferenceInsertion>& reference);
  const std::optional<ReferenceInsertion>& ghost() const { return ghost_; }

  /// Sets the force expected by a plan. It is drawn behind insertions of its array into its cochlea.
  void setPlan(const std::optional<PlannedForce>& plan);
  const std::optional<PlannedForce>& plan() const { return plan_; }
  /// Another scenario is shown. True if the plan is drawn behind it.
  bool showPlanIn(const session::Scenario& scenario);
  /// Marks the travels at which marker ribs of the scenario's array reach the opening, where a spike of the
  /// force is the rib's and not the cochlea's.
  void showRibsOf(const session::Scenario& scenario);

  /// Starts a new insertion: clears the curves, but not the earlier run. Forces are resolved along
  /// the axes of `entry`.
  void begin(const anatomy::Entry& entry);
  /// Adds the values of a snapshot to the curves.
  ///
  /// @param peak  So far; it may have been between this snapshot and the one before.
  void append(const haptics::TickOutput& now, const haptics::PeakForce& peak);
  /// Replaces the curve over travel by that of a recording, which has every tick: between two
  /// pictures a peak may be missed.
  void showRecorded(const analysis::ForceProfile& profile);
  /// Renders one visible chart that changed: of two, the one that was not rendered last. True if one did.
  bool renderNext();

  Pane* overTravel() const { return travelPane_; }
  Pane* components() const { return timePane_; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  PlainVtkWidget* chartView(QWidget* parent);

  // Charts are destroyed before the panes' widgets, because their renderers must not outlive a
  // window.
  charts::ForceDepthChart overTravel_;
  charts::ForceTimeChart components_;
  PlainVtkWidget* travelView_;
  PlainVtkWidget* timeView_;
  Pane* travelPane_;
  Pane* timePane_;
  void showExperiment();

  bool isExperimentVisible_ = true, isComparable_ = true;
  bool travelIsDirty_ = true, timeIsDirty_ = true;
  bool isTimeNext_ = false;
  double peak_N_ = 0.0;  ///< That the curve over travel has.
  anatomy::Entry entry_;
  std::optional<ReferenceInsertion> ghost_;
  std::optional<PlannedForce> plan_;
};

}  // namespace perilymph::gui
