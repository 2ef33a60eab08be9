// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs single insertions of a plan again off the window's thread, for their views.

#include <QObject>
#include <memory>
#include <vector>

#include "gui/pages/plan/PlanWork.h"
#include "gui/run/Background.h"
#include "perilymph/planning/PlannedShape.h"

namespace perilymph::gui {

/// For each array the draw that represents it, one after the other.
class PlanShapeWork : public QObject {
  Q_OBJECT
public:
  using Shape = std::shared_ptr<const planning::PlannedShape>;

  explicit PlanShapeWork(QObject* parent) : QObject(parent), background_(this) {}

  /// @param arrays  Indices into the plan's arrays.
  void run(const PlanWork::SharedPlan& plan, std::vector<std::size_t> arrays);
  void cancel() { background_.cancel(); }
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// @param place  Index into the list of arrays.
  void shapeRun(std::size_t place, const perilymph::gui::PlanShapeWork::Shape& shape);
  void failed(const QString& sentence);

private:
  void runNext(std::size_t place);

  PlanWork::SharedPlan plan_;
  std::vector<std::size_t> arrays_;
  Background background_;
};

}  // namespace perilymph::gui
