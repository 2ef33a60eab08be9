// SPDX-License-Identifier: BSD-3-Clause

// The booth rewards skill: seeded hands insert through its own scenario.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::session {
namespace {

/// Speeds of a hand on the bar, which allows 0.5 to 6 mm/s. A skilled one is slow and steady; an
/// unskilled one goes in bursts, as fast as the bar allows at times, and lets go in between.
struct HandStyle {
  double slowest, fastest;  // mean speeds [m/s]
  double unsteadiness;      // of the mean speed
  double pause;             // part of each burst in which it is let go
};
constexpr HandStyle skilled{0.5e-3, 0.9e-3, 0.1, 0.0};
constexpr HandStyle unskilled{2.0e-3, 5.0e-3, 0.6, 0.2};

class BoothHand : public device::HapticDevice {
public:
  BoothHand(const HandStyle& style, unsigned seed, double timeStep)
      : style_(style), timeStep_(timeStep)
  {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    mean_ = between(style.slowest, style.fastest);
    burst_ = between(0.8, 1.6);
    phase_ = between(0.0, 2.0 * pi);
    sample_.isValid = 1;
  }

  device::DeviceTraits traits() const override
  {
    device::DeviceTraits traits;
    traits.name = "A visitor's hand";
    traits.nominalPeriod = timeStep_;
    return traits;
  }
  Result<void> open() override { return {}; }
  void close() noexcept override {}
  device::DeviceSample read() noexcept override
  {
    if (sample_.buttons != 0) {
      time_ += timeStep_;
      const double cycle = std::fmod(time_ / burst_, 1.0);
      const double wave = std::sin(2.0 * pi * time_ / burst_ + phase_);
      const double speed = mean_ * (1.0 + style_.unsteadiness * wave);
      if (cycle >= style_.pause) advanced_ += std::clamp(speed, 0.0, 6e-3) * timeStep_;
      sample_.position_D = {0.0, 0.0, -advanced_};
    }
    sample_.buttons = device::graspButton;
    ++sample_.sequence;
    return sample_;
  }
  void write(const device::Wrench&) noexcept override {}

private:
  HandStyle style_;
  double timeStep_, mean_ = 0.0, burst_ = 1.0, phase_ = 0.0, time_ = 0.0, advanced_ = 0.0;
  device::DeviceSample sample_;
};

/// Peak force of an insertion to full depth [N]; negative if it did not reach it.
double peakOf(const Scenario& scenario, std::unique_ptr<device::HapticDevice> hand,
              const std::shared_ptr<const anatomy::ScalaTympani>& anatomy)
{
  auto insertion = Insertion::prepare(scenario.parameters(), std::move(hand), anatomy);
  if (!insertion) return -1.0;
  double peak = 0.0;
  bool isFull = false;
  const auto ran = (*insertion)
                       ->runToEnd(
                           [&](const haptics::TickRecord& record) {
                             peak = std::max(peak, record.output.axialForce);
                             isFull = record.output.workflow == haptics::Workflow::finished;
                             return true;
                           },
                           40'000);
  return ran && isFull ? peak : -1.0;
}

/// The booth's scenario with fewer, longer ticks.
constexpr double timeStep = 5e-3;  // [s]
Scenario booth(Overrides overrides = {})
{
  overrides.emplace_back("dt_ms", "5");
  return *loadScenario("booth", overrides);
}

constexpr unsigned hands = BOOTH_HANDS;

std::vector<double> peaksOf(const HandStyle& style, unsigned firstSeed)
{
  const Scenario scenario = booth();
  const auto anatomy = *buildAnatomy(scenario.parameters());
  std::vector<double> peaks(hands);
  const auto insert = [&](unsigned from) {
    for (unsigned i = from; i < hands; i += 2)
      peaks[i] =
          peakOf(scenario, std::make_unique<BoothHand>(style, firstSeed + i, timeStep), anatomy);
  };
  std::thread other(insert, 1u);
  insert(0u);
  other.join();
  return peaks;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return 0.5 * (values[values.size() / 2 - 1] + values[values.size() / 2]);
}

TEST(Booth, RanksSlowAndSteadyHandsBeforeFastAndJerkyOnes)
{
  const std::vector<double> good = peaksOf(skilled, 1000), poor = peaksOf(unskilled, 2000);
  EXPECT_GT(*std::min_element(good.begin(), good.end()), 0.0);
  EXPECT_GT(*std::min_element(poor.begin(), poor.end()), 0.0);
  EXPECT_LE(median(good), 0.7 * median(poor));
  RecordProperty("median_skilled_mN", std::to_string(1e3 * median(good)));
  RecordProperty("median_unskilled_mN", std::to_string(1e3 * median(poor)));
  // Area under the ROC curve: the probability that a skilled hand is ranked first.
  double wins = 0.0;
  for (const double a : good)
    for (const double b : poor) wins += a < b ? 1.0 : a == b ? 0.5 : 0.0;
  EXPECT_GE(wins / (hands * hands), 0.9);
}

double peakOfDemonstration(const Overrides& overrides = {})
{
  const Scenario scenario = booth(overrides);
  return peakOf(scenario, std::make_unique<device::ScriptedDevice>(scenario.speed().si(), timeStep),
                *buildAnatomy(scenario.parameters()));
}

TEST(Booth, ItsDemonstrationStaysBelowTheForcesMeasuredInPatients)
{
  const double peak = peakOfDemonstration();
  EXPECT_GT(peak, 0.0);
  EXPECT_LT(peak, 0.045);  // the lowest peak of Rau et al. 2024
}

/// The hand pushes along the array, so that only the way into the scala is bent.
TEST(Booth, AnObliqueApproachRaisesThePeakTheMoreTheSteeperItIs)
{
  const double along = peakOfDemonstration();
  const double oblique = peakOfDemonstration({{"approach_turn_deg", "10"}});
  EXPECT_GT(oblique, 1.05 * along);
  EXPECT_GT(peakOfDemonstration({{"approach_turn_deg", "20"}}), 1.05 * oblique);
  EXPECT_GT(peakOfDemonstration({{"approach_tilt_deg", "20"}}), 1.03 * along);
}

}  // namespace
}  // namespace perilymph::session
