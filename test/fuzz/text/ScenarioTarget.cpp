// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the scenario with any text and runs it for a few ticks.

#include <cmath>
#include <stdexcept>

#include "Seeds.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::fuzz {

namespace {

using session::Scenario;

/// One anatomy for all scenarios, because building one takes too long.
std::shared_ptr<const anatomy::ScalaTympani> sharedAnatomy()
{
  static const auto shared = anatomy::buildPublished(anatomy::Patient(), millimeters(1));
  return shared;
}

/// Reading the effective text gives the same text: a recording can be replayed.
void checkText(const Scenario& scenario)
{
  const auto again = session::parseScenario(scenario.text(), scenario.name());
  if (!again)
    std::fprintf(stderr, "%s\n%s\n", again.error().message.c_str(), scenario.text().c_str());
  promise(static_cast<bool>(again), "a scenario's own text can be read");
  if (again->text() != scenario.text())
    std::fprintf(stderr, "%s\n---\n%s\n", scenario.text().c_str(), again->text().c_str());
  promise(again->text() == scenario.text(), "nothing changes by reading the text again");
}

void runSome(const Scenario& scenario)
{
  // Skips models that take seconds: the surface for points, and many nodes.
  if (scenario.model() != mechanics::ModelKind::rod || scenario.nodes() > 200) return;
  auto insertion = session::Insertion::prepare(
      scenario,
      std::make_unique<device::ScriptedDevice>(scenario.speed().si(), scenario.timeStep().si()),
      std::nullopt, sharedAnatomy());
  if (!insertion) {
    promise(!insertion.error().message.empty(), "a refusal has a sentence");
    return;
  }
  const double maxForce = (*insertion)->loop().engine().safetyLimits().maxForce;
  const auto ran =
      (*insertion)
          ->runToEnd(
              [&](const haptics::TickRecord& record) {
                double squared = 0.0;
                for (const double part : record.output.wrench_D.force_D) squared += part * part;
                promise(std::sqrt(squared) <= maxForce * (1.0 + 1e-12), "a force within its limit");
                return true;
              },
              8);
  if (!ran) promise(!ran.error().message.empty(), "a fault has a sentence");
}

}  // namespace

std::vector<Bytes> seeds()
{
  std::vector<Bytes> texts;
  addFiles(resource("resources/scenarios"), ".toml", texts);
  addCorpus("scenario", texts);
  return texts;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scenario = session::parseScenario(text, "input");
  if (!scenario) {
    fuzz::promise(!scenario.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::checkText(*scenario);
  fuzz::runSome(*scenario);
  return 0;
}
