// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes a variability with any text, and draws insertions of it.

#include <cmath>

#include "InputFile.h"
#include "Seeds.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/validation/Variability.h"

namespace perilymph::fuzz {

std::vector<Bytes> seeds()
{
  return {contentOf(resource("resources/validation/published-experiment.toml"))};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("variability.toml");
  static const auto nominal = session::loadScenario("contour-published")->parameters();
  const auto variability = validation::loadVariability(file.holding({data, size}));
  if (!variability) {
    fuzz::promise(!variability.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::promise(variability->timeStep.si() > 0.0 && variability->knotSpacing.si() > 0.0,
                "steps are lengths and durations");
  for (std::uint64_t number = 0; number < 4; ++number) {
    const auto drawn = validation::drawInsertion(nominal, *variability,
                                                 validation::SpreadSources::all(), 1, number);
    fuzz::promise(std::isfinite(drawn.push.speed) && std::isfinite(drawn.push.tremorAmplitude) &&
                      std::isfinite(drawn.noiseDeviation),
                  "a drawn hand has numbers");
  }
  return 0;
}
