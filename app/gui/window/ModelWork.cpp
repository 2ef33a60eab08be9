#include "ModelWork.h"

#include <algorithm>
#include <array>

#include "Setup.h"

namespace perilymph::gui {

namespace {

using Parts = InsertionControl::Parts;

std::string valueOf(const session::Scenario& scenario, const std::string& wanted)
{
  for (const auto& [key, value] : scenario.values)
    if (key == wanted) return value;
  return {};
}

// Keys that no cochlea and no model is built from. A key that is not among them means a new model,
// needed or not.
constexpr std::array notBuiltFrom{"title", "speed_mm_s", "stop_travel_mm",       "force_scale",
                                  "side",  "patient",    "patient_numbers.label"};

Result<Parts> partsOf(const session::Scenario& scenario,
                      std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                      const std::atomic<bool>& isCanceled)
{
  const Error canceled{"Nobody waits for " + scenario.name + " any more."};
  if (isCanceled) return canceled;
  if (!anatomy) {
    auto built = session::buildAnatomy(scenario);
    if (!built) return built.error();
    anatomy = *std::move(built);
  }
  if (isCanceled) return canceled;
  auto model = session::buildModel(scenario, anatomy);
  if (!model) return model.error();
  return Parts{std::move(anatomy), *std::move(model)};
}

}  // namespace

bool haveSameCochlea(const session::Scenario& one, const session::Scenario& other)
{
  for (const char* key : {"anatomy", "lead_in_mm", "patient_numbers.st_length_mm",
                          "patient_numbers.rw_width_mm", "patient_numbers.rw_height_mm",
                          "patient_numbers.a_mm", "patient_numbers.b_mm", "patient_numbers.h_mm"})
    if (valueOf(one, key) != valueOf(other, key)) return false;
  return true;
}

bool haveSameModel(const session::Scenario& one, const session::Scenario& other)
{
  const std::vector<std::string> keys = differingKeys(one, other);
  return one.arrayFingerprint == other.arrayFingerprint &&
         std::all_of(keys.begin(), keys.end(), [](const std::string& key) {
           return std::find(notBuiltFrom.begin(), notBuiltFrom.end(), key) != notBuiltFrom.end();
         });
}

void ModelWork::build(const session::Scenario& scenario,
                      std::shared_ptr<const anatomy::ScalaTympani> anatomy, Answer answer)
{
  if (!isBusy()) since_.start();  // who waits has waited since the first request
  background_.run(
      "The cochlea",
      [scenario, anatomy = std::move(anatomy)](const std::atomic<bool>& isCanceled) {
        return partsOf(scenario, anatomy, isCanceled);
      },
      std::move(answer));
}

}  // namespace perilymph::gui
