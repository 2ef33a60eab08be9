// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanShapeWork.h"

#include <optional>
#include <stop_token>
#include <utility>

#include "gui/text/DataText.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/planning/PlannedDraw.h"

namespace perilymph::gui {

void PlanShapeWork::run(const PlanWork::SharedPlan& plan, std::vector<std::size_t> arrays)
{
  plan_ = plan;
  arrays_ = std::move(arrays);
  runNext(0);
}

void PlanShapeWork::runNext(std::size_t place)
{
  if (place >= arrays_.size()) return;
  background_.run(
      "The view of the array",
      [plan = plan_, array = arrays_[place]](const std::stop_token& stop) -> Result<Shape> {
        std::optional<Result<planning::PlannedShape>> shape;
        const auto work = [&](std::size_t, const std::stop_token& ending) -> Result<void> {
          shape = planning::shapeOf(*plan, array, planning::medianDraw(*plan, array), ending);
          return {};
        };
        // insertions run in threads of their own
        const auto ran = doInParallel(1, 1, work, {}, stop);
        if (!ran) return ran.error();
        if (!*shape) return shape->error();
        return std::make_shared<const planning::PlannedShape>(**std::move(shape));
      },
      [this, place](const Result<Shape>& shape) {
        if (!shape) return failed(dataText(shape.error().message));
        Q_EMIT shapeRun(place, *shape);
        runNext(place + 1);
      });
}

}  // namespace perilymph::gui
