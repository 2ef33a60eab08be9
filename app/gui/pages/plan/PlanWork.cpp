// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanWork.h"

#include <algorithm>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/foundation/UtcTime.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanReport.h"

namespace perilymph::gui {

namespace {

constexpr int reportInterval_ms = 250;
constexpr std::size_t firstDraws = 8;

/// All processors but one, which the window and a haptic loop share.
unsigned jobsBesideWindow() { return std::max(2u, processors()) - 1; }

}  // namespace

PlanWork::PlanWork(QObject* parent) : QObject(parent), background_(this)
{
  timer_.setInterval(reportInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &PlanWork::report);
}

void PlanWork::compute(const planning::PlanRequest& request)
{
  shared_ = std::make_shared<Shared>();
  StoredPlan stored{folderOfPlan(request), request, 0, false, utcNow()};
  stored.request.jobs = jobsBesideWindow();
  background_.run(
      "The plan",
      [shared = shared_, stored](const std::stop_token& stop) {
        return make(*shared, stored, stop);
      },
      [this](const Result<void>& done) {
        timer_.stop();
        report();
        Q_EMIT ended(done ? QString() : dataText(done.error().message));
      });
  timer_.start();
}

Result<void> PlanWork::make(Shared& shared, StoredPlan stored, const std::stop_token& stop)
{
  if (const auto saved = planning::savePlanFolder(stored); !saved) return saved;
  const planning::PlanRequest& all = stored.request;
  const auto progress = [&](std::size_t done, std::size_t) {
    const std::lock_guard lock(shared.mutex);
    shared.done = done;
    shared.all = all.draws * all.arrays.size();
  };
  // the plan of some draws, or of all; true if its bands stand
  const auto show = [&](const planning::PlanRequest& part) -> Result<bool> {
    auto plan = planning::makePlan(part, stored.folder / planDrawsFile, progress, stop);
    if (!plan) return plan.error();
    plan->request = all;
    stored.shownDraws = plan->insertions.size() / all.arrays.size();
    if (const auto saved = planning::savePlanFolder(stored); !saved) return saved.error();
    const auto json = planning::planJson(*plan);
    if (!json) return json.error();
    if (const auto saved = writeWhole(stored.folder / planJsonFile, *json); !saved)
      return saved.error();
    const bool haveConverged = planning::hasConverged(*plan);
    const std::lock_guard lock(shared.mutex);
    shared.plan = std::make_shared<const planning::Plan>(*std::move(plan));
    shared.stored = stored;
    return haveConverged;
  };
  for (std::size_t draws = firstDraws; draws < all.draws; draws *= 2) {
    planning::PlanRequest part = all;
    part.draws = draws;
    part.stopsEarly = false;
    const auto haveConverged = show(part);
    if (!haveConverged) return haveConverged.error();
    if (*haveConverged && draws > firstDraws && all.stopsEarly) break;
  }
  stored.isComplete = true;
  const auto last = show(all);
  if (!last) return last.error();
  return {};
}

void PlanWork::open(const StoredPlan& stored)
{
  timer_.stop();
  background_.run(
      "The plan",
      [stored](const std::stop_token&) -> Result<SharedPlan> {
        planning::PlanRequest kept = stored.request;
        kept.draws = stored.shownDraws;
        auto plan = planning::viewPlan(kept, stored.folder / planDrawsFile);
        if (!plan) return plan.error();
        plan->request = stored.request;
        return std::make_shared<const planning::Plan>(*std::move(plan));
      },
      [this, stored](const Result<SharedPlan>& plan) {
        if (!plan) return ended(dataText(plan.error().message));
        Q_EMIT shown(*plan, stored);
        Q_EMIT ended({});
      });
}

void PlanWork::cancel()
{
  background_.cancel();
  timer_.stop();
  if (shared_) report();
}

void PlanWork::report()
{
  SharedPlan plan;
  StoredPlan stored;
  std::size_t done = 0, all = 0;
  {
    const std::lock_guard lock(shared_->mutex);
    plan = std::exchange(shared_->plan, nullptr);
    stored = shared_->stored;
    done = shared_->done;
    all = shared_->all;
  }
  if (plan) Q_EMIT shown(plan, stored);
  if (all > 0) Q_EMIT progressed(done, all);
}

}  // namespace perilymph::gui
