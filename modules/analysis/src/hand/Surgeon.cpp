// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Surgeon.h"

#include <cmath>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::analysis {

namespace {

/// Uses of random numbers, apart from those of a SpreadSource.
enum class Draw : std::uint64_t {
  speed = 100,
  tremor,
  freeLength,
  stop,
  friction,
  rupture,
  sharedFriction,
  intended
};

/// Deviates beyond which a friction is not drawn (choice, high).
constexpr double maxDeviates = 3.0;

TomlReader sourcedTable(TomlReader& file, const char* key, HandDistribution& hand)
{
  TomlReader table = file.table(key);
  const std::string source = table.text("source");
  hand.provenance.push_back(
      {key, source, table.choice("confidence", {"high", "medium", "low"}, std::nullopt)});
  return table;
}

void readMotion(TomlReader& file, HandDistribution& hand)
{
  TomlReader speed = sourcedTable(file, "speed", hand);
  hand.speedMean = millimetersPerSecond(speed.number("mean_mm_s", {0.01, 10.0}));
  hand.speedDeviation = millimetersPerSecond(speed.number("sd_mm_s", {0.0, 10.0}));
  hand.speedLow = millimetersPerSecond(speed.number("low_mm_s", {0.01, 10.0}));
  hand.speedHigh = millimetersPerSecond(
      speed.number("high_mm_s", {inMillimetersPerSecond(hand.speedLow), 10.0}));
  TomlReader tremor = sourcedTable(file, "tremor", hand);
  hand.tremorLow = millimeters(tremor.number("low_mm", {0.0, 0.5}));
  hand.tremorHigh = millimeters(tremor.number("high_mm", {inMillimeters(hand.tremorLow), 0.5}));
  hand.tremorFrequency = tremor.number("frequency_Hz", {0.0, 30.0});
  TomlReader free = sourcedTable(file, "free_length", hand);
  hand.freeLengthLow = millimeters(free.number("low_mm", {1.0, 60.0}));
  hand.freeLengthHigh =
      millimeters(free.number("high_mm", {inMillimeters(hand.freeLengthLow), 60.0}));
}

void readEnd(TomlReader& file, HandDistribution& hand)
{
  TomlReader stop = sourcedTable(file, "stop", hand);
  hand.stopLow = newtons(stop.number("low_N", {0.001, 2.0}));
  hand.stopHigh = newtons(stop.number("high_N", {hand.stopLow.si(), 2.0}));
  TomlReader intended = sourcedTable(file, "intended_depth", hand);
  hand.intendedLow = intended.number("low", {0.0, 1.0});
  hand.intendedHigh = intended.number("high", {hand.intendedLow, 1.0});
  TomlReader rest = sourcedTable(file, "rest", hand);
  hand.rest = seconds(rest.number("duration_s", {0.1, 60.0}));
  hand.restMean = seconds(rest.number("mean_of_last_s", {0.01, hand.rest.si()}));
  TomlReader buckling = sourcedTable(file, "buckling", hand);
  hand.bucklingLag = millimeters(buckling.number("lag_mm", {0.1, 10.0}));
}

void readTissue(TomlReader& file, HandDistribution& hand)
{
  TomlReader friction = sourcedTable(file, "friction", hand);
  hand.frictionDeviation = friction.number("sd_fraction", {0.0, 1.0});
  TomlReader rupture = sourcedTable(file, "rupture", hand);
  hand.ruptureMean = newtons(rupture.number("mean_N", {0.001, 2.0}));
  hand.ruptureDeviation = newtons(rupture.number("sd_N", {0.0, 2.0}));
  hand.ruptureLow = newtons(rupture.number("low_N", {0.0, hand.ruptureMean.si()}));
  hand.ruptureHigh = newtons(rupture.number("high_N", {hand.ruptureMean.si(), 2.0}));
}

}  // namespace

Result<HandDistribution> loadHand(const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  HandDistribution hand;
  reader->text("label");
  readMotion(*reader, hand);
  readEnd(*reader, hand);
  readTissue(*reader, hand);
  if (const auto done = reader->finish(); !done) return done.error();
  return hand;
}

std::filesystem::path shippedHandFile() { return resource("resources/clinical/hand.toml"); }

Result<HandDistribution> shippedHand() { return loadHand(shippedHandFile()); }

Surgeon drawSurgeon(const HandDistribution& hand, std::uint64_t seed, std::uint64_t number,
                    const session::FrictionSpread& spread)
{
  const auto stream = [&](Draw draw) {
    return RandomStream(seed, number, static_cast<std::uint64_t>(draw));
  };
  const auto within = [&](Draw draw, double low, double high) {
    return stream(draw).between(low, high);
  };
  Surgeon one;
  one.speed = metersPerSecond(stream(Draw::speed)
                                  .normal(hand.speedMean.si(), hand.speedDeviation.si(),
                                          hand.speedLow.si(), hand.speedHigh.si()));
  RandomStream tremor = stream(Draw::tremor);
  one.tremor = meters(tremor.between(hand.tremorLow.si(), hand.tremorHigh.si()));
  for (double& phase : one.tremorPhase) phase = tremor.between(0.0, 2.0 * pi);
  one.freeLength =
      meters(within(Draw::freeLength, hand.freeLengthLow.si(), hand.freeLengthHigh.si()));
  one.stop = newtons(within(Draw::stop, hand.stopLow.si(), hand.stopHigh.si()));
  one.intended = within(Draw::intended, hand.intendedLow, hand.intendedHigh);
  const double deviate = stream(Draw::friction).normal(0.0, 1.0, -maxDeviates, maxDeviates);
  if (spread.isKnown()) {
    const double shared = stream(Draw::sharedFriction).normal(0.0, 1.0, -maxDeviates, maxDeviates);
    one.sharedFriction = spread.shared * shared;
    one.frictionFactor = exponential(spread.shared * shared + spread.ear * deviate);
  } else {
    const double variance = logarithm(1.0 + hand.frictionDeviation * hand.frictionDeviation);
    one.frictionFactor = exponential(std::sqrt(variance) * deviate - 0.5 * variance);
  }
  one.rupture = newtons(stream(Draw::rupture)
                            .normal(hand.ruptureMean.si(), hand.ruptureDeviation.si(),
                                    hand.ruptureLow.si(), hand.ruptureHigh.si()));
  return one;
}

}  // namespace perilymph::analysis
