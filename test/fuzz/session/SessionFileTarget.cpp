// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the `.insertion` file with any bytes: opened, read and prepared for replay.

#include "InputFile.h"
#include "MakeEngine.h"
#include "Seeds.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::fuzz {

namespace {

/// A prepared scenario, which a replay needs in addition to the facts.
struct Prepared {
  session::Scenario scenario;
  std::shared_ptr<const mechanics::InsertionModel> model;
};

const Prepared& prepared()
{
  static const Prepared one = [] {
    auto scenario = session::loadScenario("contour-published", {{"nodes", "16"}});
    promise(static_cast<bool>(scenario), "a scenario is shipped");
    const auto anatomy = session::buildAnatomy(*scenario);
    promise(static_cast<bool>(anatomy), "its cochlea can be built");
    const auto model = session::buildModel(*scenario, *anatomy);
    promise(static_cast<bool>(model), "its model can be built");
    return Prepared{*scenario, *model};
  }();
  return one;
}

/// The facts of the file give an engine or an error, and the engine can run its ticks.
void use(const session::RecordedInsertion& recorded)
{
  const auto scenario = session::parseScenario(recorded.facts().scenarioText, "input");
  if (!scenario) promise(!scenario.error().message.empty(), "a refusal has a sentence");

  const auto check = recorded.check();
  if (!check) promise(!check.error().message.empty(), "a refusal has a sentence");

  auto engine =
      session::makeEngine(prepared().scenario.parameters(), prepared().model, recorded.facts().run);
  if (!engine) promise(!engine.error().message.empty(), "a refusal has a sentence");
  std::uint64_t seen = 0;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    if (engine) (*engine)->tick(record.sample, record.commands);
    return ++seen < 8;
  });
  if (!read) promise(!read.error().message.empty(), "a refusal has a sentence");
}

}  // namespace

std::vector<Bytes> seeds() { return corpusOf("session_file"); }

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("some.insertion");
  {
    const auto recorded = session::RecordedInsertion::open(file.holding({data, size}));
    if (recorded)
      fuzz::use(*recorded);
    else
      fuzz::promise(!recorded.error().message.empty(), "a refusal has a sentence");
  }
  fuzz::promise(file.strangers() == 0, "reading leaves nothing behind");
  return 0;
}
