// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/validate/ValidationWork.h"

#include <stop_token>

#include "gui/text/DataText.h"

namespace perilymph::gui {

namespace {

constexpr int reportInterval_ms = 250;

analysis::ValidationResult partOf(const std::vector<std::vector<double>>& curves)
{
  analysis::ValidationResult part;
  part.runs = static_cast<int>(curves.size());
  if (curves.size() < 2) return part;
  std::vector<double> values(curves.size());
  for (std::size_t point = 0; point < curves.front().size(); ++point) {
    for (std::size_t i = 0; i < curves.size(); ++i) values[i] = curves[i][point];
    part.profile.push_back({static_cast<double>(point) * analysis::profileStep().si(),
                            analysis::statisticsOf(values)});
  }
  return part;
}

}  // namespace

Result<ValidationBasis> shippedBasis()
{
  auto references = analysis::validationReferences();
  if (!references) return references.error();
  auto request = analysis::shippedValidation(*references);
  if (!request) return request.error();
  return ValidationBasis{*std::move(request), *std::move(references)};
}

ValidationWork::ValidationWork(QObject* parent) : QObject(parent), background_(this)
{
  timer_.setInterval(reportInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &ValidationWork::report);
}

void ValidationWork::start(analysis::ValidationRequest request)
{
  if (isRunning()) return;
  shared_ = std::make_shared<Shared>();
  wasCanceled_ = false;
  request.onCurve = [shared = shared_](const std::vector<double>& curve) {
    const std::lock_guard lock(shared->mutex);
    shared->curves.push_back(curve);
  };
  background_.run(
      "The validation",
      [shared = shared_, request = std::move(request)](const std::stop_token& stop) {
        const auto progress = [&](std::size_t done, std::size_t all) {
          const std::lock_guard lock(shared->mutex);
          shared->done = done;
          shared->all = all;
        };
        return analysis::validate(request, progress, stop);
      },
      [this](const Result<analysis::ValidationResult>& result) {
        timer_.stop();
        if (result) return finished(*result, {});
        finished(std::nullopt, wasCanceled_ ? tr("Canceled. No results were saved.")
                                            : dataText(result.error().message));
      });
  timer_.start();
}

void ValidationWork::cancel()
{
  wasCanceled_ = isRunning();
  background_.requestStop();
}

void ValidationWork::report()
{
  std::vector<std::vector<double>> curves;
  int done = 0, all = 0;
  {
    const std::lock_guard lock(shared_->mutex);
    curves = shared_->curves;
    done = static_cast<int>(shared_->done);
    all = static_cast<int>(shared_->all);
  }
  Q_EMIT progressed(done, all, partOf(curves));
}

}  // namespace perilymph::gui
