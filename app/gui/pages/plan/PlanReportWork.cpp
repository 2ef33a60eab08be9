// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanReportWork.h"

#include <stop_token>
#include <utility>

#include "gui/report/PlanReportPdf.h"
#include "gui/report/ReportSending.h"
#include "gui/text/DataText.h"
#include "perilymph/planning/PlanReport.h"

namespace perilymph::gui {

PlanReportWork::PlanReportWork(QObject* parent) : QObject(parent), background_(this), saving_(this)
{
  connect(&saving_, &ReportSaving::saved, this, &PlanReportWork::written);
  connect(&saving_, &ReportSaving::failed, this, &PlanReportWork::failed);
}

void PlanReportWork::build(const PlanWork::SharedPlan& plan, const std::filesystem::path& folder,
                           std::function<void(const PlanReportContent&)> then)
{
  background_.run(
      "The report",
      [plan, folder](const std::stop_token&) -> Result<PlanReportContent> {
        // the report states the numbers of plan.json
        const auto json = planning::planJson(*plan);
        if (!json) return json.error();
        auto stored =
            plan->isCurrent ? planning::planIn(*json, "plan.json") : planning::readPlan(folder);
        if (!stored) return stored.error();
        return planReportContent(*std::move(stored));
      },
      [this, then = std::move(then)](const Result<PlanReportContent>& content) {
        if (!content) return failed(dataText(content.error().message));
        then(*content);
      });
}

void PlanReportWork::write(const PlanWork::SharedPlan& plan, const std::filesystem::path& folder,
                           const ReportPlace& place)
{
  build(plan, folder, [this, place](const PlanReportContent& content) {
    saving_.save(
        [&content](const std::filesystem::path& pdf) { return writePlanReport(content, pdf); },
        content.identity(), place);
  });
}

void PlanReportWork::prepare(const PlanWork::SharedPlan& plan, const std::filesystem::path& folder)
{
  build(plan, folder, [this](const PlanReportContent& content) {
    const auto pdf = pdfToSend(
        [&content](const std::filesystem::path& place) { return writePlanReport(content, place); },
        content.identity());
    if (!pdf) return failed(dataText(pdf.error().message));
    Q_EMIT prepared(*pdf, content.identity());
  });
}

}  // namespace perilymph::gui
