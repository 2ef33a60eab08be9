// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RecordedFacts.h"

#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "perilymph/foundation/Choice.h"
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

std::optional<bool> flagIn(const MetaRows& rows, const char* key)
{
  static constexpr std::array flags{Choice<bool>{false, "0"}, Choice<bool>{true, "1"}};
  const auto found = rows.find(key);
  return found == rows.end() ? false : valueIn(flags, found->second);
}

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
  facts.run.offTime = 0.0;
  for (const auto& [key, number] : {std::pair{MetaKey::offTime, &facts.run.offTime},
                                    {MetaKey::reach, &facts.run.reach},
                                    {MetaKey::maxStiffness, &facts.run.maxStiffness},
                                    {MetaKey::maxDamping, &facts.run.maxDamping},
                                    {MetaKey::restAfter, &facts.run.restAfter},
                                    {MetaKey::restMotion, &facts.run.restMotion},
                                    {MetaKey::restHandMotion, &facts.run.restHandMotion},
                                    {MetaKey::deviceDelay, &facts.deviceDelay}}) {
    if (rows.count(key) == 0) continue;
    const auto read = numberIn<double>(rows, key);
    if (!read) return std::nullopt;
    *number = *read;
  }
  const auto feelsForce = flagIn(rows, MetaKey::feelsForce);
  if (!feelsForce) return std::nullopt;
  facts.run.feelsForce = *feelsForce;
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
  const auto end = rows.find(highlightEnd);  // not in recordings before this key
  if (end == rows.end()) return std::nullopt;
  noted.end = haptics::endNamed(end->second);
  return noted;
}

std::optional<std::uint64_t> countIn(const MetaRows& rows, const char* key)
{
  return numberIn<std::uint64_t>(rows, key);
}

}  // namespace perilymph::session
