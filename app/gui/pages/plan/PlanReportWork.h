// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The report of a plan as PDF.

#include <QObject>
#include <filesystem>

#include "gui/pages/plan/PlanWork.h"
#include "gui/run/Background.h"

namespace perilymph::gui {

/// Builds the cochlea for the report off the window's thread, then writes the report.
class PlanReportWork : public QObject {
  Q_OBJECT
public:
  explicit PlanReportWork(QObject* parent) : QObject(parent), background_(this) {}

  /// @param folder  The plan's: a plan that is not current is reported as its plan.json states it.
  void write(const PlanWork::SharedPlan& plan, const std::filesystem::path& folder,
             const std::filesystem::path& pdf);

Q_SIGNALS:
  void written(const std::filesystem::path& pdf);
  void failed(const QString& sentence);

private:
  Background background_;
};

}  // namespace perilymph::gui
