// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/ModelBuilder.h"

namespace perilymph::gui {

namespace {

using Parts = InsertionControl::Parts;

Result<Parts> partsOf(CochleaStore& cochleae, const session::Scenario& scenario,
                      std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                      const std::atomic<bool>& isCanceled)
{
  const Error canceled{"Nobody waits for " + scenario.name() + " any more."};
  if (isCanceled) return canceled;
  if (!anatomy) {
    auto built = cochleae.cochleaOf(scenario);
    if (!built) return built.error();
    anatomy = *std::move(built);
  }
  if (isCanceled) return canceled;
  auto model = session::buildModel(scenario, anatomy);
  if (!model) return model.error();
  if (isCanceled) return canceled;
  (*model)->prepareForRealTime();  // here, so that the window need not wait for it at the start
  return Parts{std::move(anatomy), *std::move(model)};
}

}  // namespace

void ModelBuilder::build(const session::Scenario& scenario,
                         std::shared_ptr<const anatomy::ScalaTympani> anatomy, Answer answer)
{
  if (!isBusy()) since_.start();  // measured from the first request
  background_.run(
      "The cochlea",
      [cochleae = cochleae_, scenario,
       anatomy = std::move(anatomy)](const std::atomic<bool>& isCanceled) {
        return partsOf(*cochleae, scenario, anatomy, isCanceled);
      },
      std::move(answer));
}

}  // namespace perilymph::gui
