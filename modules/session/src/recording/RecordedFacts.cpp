// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RecordedFacts.h"

#include <charconv>
#include <string>
#include <utility>

#include "perilymph/session/Csv.h"
#include "recording/HighlightKeys.h"

namespace perilymph::session {

namespace {

template <class Number>
std::optional<Number> numberIn(const MetaRows& rows, const char* key)
{
  const auto found = rows.find(key);
  if (found == rows.end()) return std::nullopt;
  const std::string& text = found->second;
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

MetaRows metaRowsOf(const RecordingFacts& facts)
{
  return {{MetaKey::scenarioName, facts.scenarioName},
          {MetaKey::scenario, facts.scenarioText},
          {MetaKey::device, facts.device},
          {MetaKey::timeStep, shortestDecimal(facts.timeStep)},
          {MetaKey::samplePeriod, shortestDecimal(facts.run.samplePeriod)},
          {MetaKey::maxForce, shortestDecimal(facts.run.maxForce)},
          {MetaKey::offTime, shortestDecimal(facts.run.offTime)},
          {MetaKey::reach, shortestDecimal(facts.run.reach)},
          {MetaKey::feelsForce, facts.run.feelsForce ? "1" : "0"},
          {MetaKey::maxStiffness, shortestDecimal(facts.run.maxStiffness)},
          {MetaKey::maxDamping, shortestDecimal(facts.run.maxDamping)},
          {MetaKey::restAfter, shortestDecimal(facts.run.restAfter)},
          {MetaKey::restMotion, shortestDecimal(facts.run.restMotion)},
          {MetaKey::restHandMotion, shortestDecimal(facts.run.restHandMotion)},
          {MetaKey::deviceDelay, shortestDecimal(facts.deviceDelay)},
          {MetaKey::seed, std::to_string(facts.seed)},
          {MetaKey::modelFingerprint, std::to_string(facts.modelFingerprint)},
          {MetaKey::version, facts.version},
          {MetaKey::buildId, facts.buildId},
          {MetaKey::startedUtc, facts.startedUtc},
          {MetaKey::lostRecords, "0"},
          {MetaKey::closed, "0"}};
}

std::optional<RecordingFacts> factsIn(const MetaRows& rows)
{
  RecordingFacts facts;
  const std::pair<const char*, std::string*> texts[] = {
      {MetaKey::scenarioName, &facts.scenarioName},
      {MetaKey::scenario, &facts.scenarioText},
      {MetaKey::device, &facts.device},
      {MetaKey::version, &facts.version},
      {MetaKey::buildId, &facts.buildId},
      {MetaKey::startedUtc, &facts.startedUtc}};
  for (const auto& [key, text] : texts) {
    const auto found = rows.find(key);
    if (found == rows.end()) return std::nullopt;
    *text = found->second;
  }
  const auto timeStep = numberIn<double>(rows, MetaKey::timeStep);
  const auto samplePeriod = numberIn<double>(rows, MetaKey::samplePeriod);
  const auto maxForce = numberIn<double>(rows, MetaKey::maxForce);
  const auto seed = numberIn<long>(rows, MetaKey::seed);
  const auto fingerprint = numberIn<std::uint64_t>(rows, MetaKey::modelFingerprint);
  if (!timeStep || !samplePeriod || !maxForce || !seed || !fingerprint) return std::nullopt;
  facts.timeStep = *timeStep;
  facts.run.samplePeriod = *samplePeriod;
  facts.run.maxForce = *maxForce;
  // Early recordings lack the remaining facts. Without an off time, a force was switched off at
  // the normal slew rate.
  facts.run.offTime = numberIn<double>(rows, MetaKey::offTime).value_or(0.0);
  facts.run.reach = numberIn<double>(rows, MetaKey::reach).value_or(facts.run.reach);
  facts.run.feelsForce = numberIn<int>(rows, MetaKey::feelsForce).value_or(0) != 0;
  facts.run.maxStiffness =
      numberIn<double>(rows, MetaKey::maxStiffness).value_or(facts.run.maxStiffness);
  facts.run.maxDamping = numberIn<double>(rows, MetaKey::maxDamping).value_or(facts.run.maxDamping);
  facts.run.restAfter = numberIn<double>(rows, MetaKey::restAfter).value_or(facts.run.restAfter);
  facts.run.restMotion = numberIn<double>(rows, MetaKey::restMotion).value_or(facts.run.restMotion);
  facts.run.restHandMotion =
      numberIn<double>(rows, MetaKey::restHandMotion).value_or(facts.run.restHandMotion);
  facts.deviceDelay = numberIn<double>(rows, MetaKey::deviceDelay).value_or(facts.deviceDelay);
  facts.seed = *seed;
  facts.modelFingerprint = *fingerprint;
  return facts;
}

std::optional<Highlights> highlightsIn(const MetaRows& rows)
{
  Highlights noted;
  const auto ticks = countIn(rows, MetaKey::ticks);
  if (!ticks) return std::nullopt;
  noted.ticks = *ticks;
  for (const auto& [key, field] : highlightKeys) {
    const auto number = numberIn<double>(rows, key);
    if (!number) return std::nullopt;
    noted.*field = *number;
  }
  return noted;
}

std::optional<std::uint64_t> countIn(const MetaRows& rows, const char* key)
{
  return numberIn<std::uint64_t>(rows, key);
}

}  // namespace perilymph::session
