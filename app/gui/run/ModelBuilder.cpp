// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/ModelBuilder.h"

#include <stop_token>

namespace perilymph::gui {

namespace {

using Parts = InsertionControl::Parts;

Result<Parts> partsOf(CochleaStore& cochleae, const session::Scenario& scenario,
                      std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                      const std::stop_token& stop)
{
  const Error canceled{"Nobody waits for " + scenario.name() + " any more."};
  if (stop.stop_requested()) return canceled;
  if (!anatomy) {
    auto built = cochleae.cochleaOf(scenario);
    if (!built) return built.error();
    anatomy = *std::move(built);
  }
  if (stop.stop_requested()) return canceled;
  auto model = session::buildModel(scenario, anatomy);
  if (!model) return model.error();
  if (stop.stop_requested()) return canceled;
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
      [cochleae = cochleae_, scenario, anatomy = std::move(anatomy)](const std::stop_token& stop) {
        return partsOf(*cochleae, scenario, anatomy, stop);
      },
      std::move(answer));
}

}  // namespace perilymph::gui
