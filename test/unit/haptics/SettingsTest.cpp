// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

TEST(EngineSettings, AreRefusedOutOfRangeWithASentenceThatNamesTheValue)
{
  struct Case {
    std::function<void(EngineSettings&)> spoil;
    std::string named;
  };
  const std::vector<Case> cases{
      {[](auto& s) { s.coupling = mechanics::Coupling::spring, s.couplingStiffness = -50; },
       "-50 N/m"},
      {[](auto& s) { s.coupling = mechanics::Coupling::spring, s.couplingDamping = -1; },
       "-1 N.s/m"},
      {[](auto& s) { s.stopTravel = 0.0; }, "0 mm"},
      {[](auto& s) { s.stopTravel = std::nan(""); }, "nan mm"},
      {[](auto& s) { s.forceScale = 1e6; }, "1e+06"},
      {[](auto& s) { s.motionScale = 0.0; }, "0 "},
      {[](auto& s) { s.styletSpeed = -1e-3; }, "-1 mm/s"},
      {[](auto& s) { s.samplePeriod = 0.0; }, "0 ms"},
  };
  for (const Case& error : cases) {
    EngineSettings settings;
    error.spoil(settings);
    try {
      InsertionEngine engine(test::insertionInTube(), settings);
      ADD_FAILURE() << "accepted " << error.named;
    } catch (const std::invalid_argument& refusal) {
      const std::string sentence = refusal.what();
      EXPECT_NE(sentence.find(error.named), std::string::npos) << sentence;
      EXPECT_NE(sentence.find("between"), std::string::npos) << sentence;
    }
  }
}

TEST(InsertionEngine, NeedsAModel)
{
  EXPECT_THROW(InsertionEngine(nullptr, {}), std::invalid_argument);
}

TEST(HapticLoop, NeedsAnEngine)
{
  device::ScriptedDevice hand(2e-3, 1e-3);
  EXPECT_THROW(HapticLoop(hand, nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace perilymph::haptics
