#pragma once

// All that shows an insertion: the picture, the charts and the flat views, and how they share the
// page.

#include <QWidget>

#include "PaneArea.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

class FlatViews;
class ForceCharts;
class OperationView;

/// The parts of the insertion page between the panel and the bar at the bottom. Which of them are
/// seen is kept in the settings.
class InsertionViews : public PaneArea {
  Q_OBJECT
public:
  explicit InsertionViews(QWidget* parent);
  ~InsertionViews() override;

  OperationView* operation() const { return operation_; }
  ForceCharts* charts() const { return charts_; }

  /// The cochlea and the array to be shown from now on. The cochlea must outlive the views, the
  /// next call, or forgetScene().
  void setScene(const anatomy::ScalaTympani& scala, const session::Scenario& scenario);
  /// The cochlea is about to go.
  void forgetScene();
  /// What follows the array fifteen times a second.
  void showSlowly(const haptics::Snapshot& now);

protected:
  QSize minimumSizeHint() const override;

private:
  void connectParts();

  OperationView* operation_;
  ForceCharts* charts_;
  FlatViews* flat_;
};

}  // namespace perilymph::gui
