// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The report of a plan.

#include <QObject>
#include <filesystem>
#include <functional>
#include <string>

#include "gui/pages/plan/PlanWork.h"
#include "gui/report/PlanReportContent.h"
#include "gui/report/ReportSaving.h"
#include "gui/run/Background.h"

namespace perilymph::gui {

/// Builds the cochlea for the report off the window's thread, then writes the report.
class PlanReportWork : public QObject {
  Q_OBJECT
public:
  explicit PlanReportWork(QObject* parent);

  /// @param folder  The plan's: a plan that is not current is reported as its plan.json states it.
  void write(const PlanWork::SharedPlan& plan, const std::filesystem::path& folder,
             const ReportPlace& place);

  /// Makes the PDF for an archive; prepared() has it.
  void prepare(const PlanWork::SharedPlan& plan, const std::filesystem::path& folder);

Q_SIGNALS:
  void prepared(const std::string& pdf, const perilymph::gui::ReportIdentity& identity);
  void written(const std::filesystem::path& report, const QString& sentence);
  void failed(const QString& sentence);

private:
  /// Builds what the report states, and gives it to `then` in the window's thread.
  void build(const PlanWork::SharedPlan& plan, const std::filesystem::path& folder,
             std::function<void(const PlanReportContent&)> then);

  Background background_;
  ReportSaving saving_;
};

}  // namespace perilymph::gui
