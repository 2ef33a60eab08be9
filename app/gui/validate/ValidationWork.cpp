#include "ValidationWork.h"

#include "perilymph/foundation/RealTime.h"

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

ValidationWork::ValidationWork(QObject* parent) : QObject(parent)
{
  thread_.setMaxThreadCount(1);
  timer_.setInterval(reportInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &ValidationWork::report);
}

ValidationWork::~ValidationWork()
{
  cancel();
  thread_.waitForDone();
}

void ValidationWork::start(analysis::ValidationRequest request)
{
  if (isRunning_) return;
  isRunning_ = true;
  shared_ = std::make_shared<Shared>();
  request.onCurve = [shared = shared_](const std::vector<double>& curve) {
    const std::lock_guard lock(shared->mutex);
    shared->curves.push_back(curve);
  };
  thread_.start([this, shared = shared_, request = std::move(request)] {
    registerThreadRole(ThreadRole::worker);
    auto result = analysis::validate(request, [&shared](std::size_t done, std::size_t all) {
      const std::lock_guard lock(shared->mutex);
      shared->done = done;
      shared->all = all;
      return !shared->isCanceled;
    });
    QMetaObject::invokeMethod(
        this,
        [this, shared, result = std::move(result)] {
          timer_.stop();
          isRunning_ = false;
          if (result) return finished(*result, {});
          finished(std::nullopt, shared->isCanceled
                                     ? tr("Canceled. Nothing was kept.")
                                     : QString::fromStdString(result.error().message));
        },
        Qt::QueuedConnection);
  });
  timer_.start();
}

void ValidationWork::cancel()
{
  if (shared_) shared_->isCanceled = true;
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
