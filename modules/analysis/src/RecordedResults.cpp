// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/RecordedResults.h"

#include <algorithm>
#include <iterator>

#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Playback.h"
#include "perilymph/session/RecordedInsertion.h"

namespace perilymph::analysis {

namespace {

/// The first snapshot at maximum depth.
Result<void> findDeepest(session::Playback& playback, haptics::Snapshot& deepest)
{
  const auto& samples = playback.samples();
  const auto found = std::max_element(
      samples.begin(), samples.end(),
      [](const auto& one, const auto& other) { return one.output.depth < other.output.depth; });
  // between this sample and the next one it may be deeper
  const std::uint64_t end = found + 1 == samples.end() ? playback.ticks() : std::next(found)->place;
  if (const auto done = playback.show(found->place, deepest); !done) return done.error();
  haptics::Snapshot next{};
  for (std::uint64_t place = found->place + 1; place < end; ++place) {
    if (const auto done = playback.show(place, next); !done) return done.error();
    if (next.output.depth <= deepest.output.depth) break;
    deepest = next;
  }
  return {};
}

/// Where a hand of the plans would have stopped, if the insertion went on.
Result<std::optional<PassedStop>> findPassedStop(const std::filesystem::path& file,
                                                 session::Playback& playback)
{
  using Found = std::optional<PassedStop>;
  const auto hand = shippedHand();
  if (!hand) return hand.error();
  const session::Scenario& scenario = playback.scenario();
  const auto stop = stopToPass(scenario.parameters(), *hand);
  if (!stop) return Found();
  const auto recorded = session::RecordedInsertion::open(file);
  if (!recorded) return recorded.error();
  std::uint64_t place = 0;
  bool isPassed = false;
  const auto read = recorded->forEach([&](const haptics::TickRecord& record) {
    isPassed = haptics::raisesPeak(record.output, stop->si());
    if (!isPassed) ++place;
    return !isPassed;
  });
  if (!read) return read.error();
  if (!isPassed || place >= playback.ticks()) return Found();
  haptics::Snapshot at{};
  if (const auto done = playback.show(place, at); !done) return done.error();
  return Found(passedStop(*playback.anatomy(), scenario.array(), *stop, at));
}

}  // namespace

Result<RecordedResults> recordedResults(const std::filesystem::path& file,
                                        const std::stop_token& stop)
{
  RecordedResults results;
  auto insertion = readCompared(file, stop);
  if (!insertion) return insertion.error();
  results.insertion = *std::move(insertion);
  const auto playback = session::Playback::open(file);
  if (!playback) return playback.error();
  results.scenario = (*playback)->scenario();
  const auto verification = (*playback)->compute(stop);
  if (!verification) return verification.error();
  results.verification = *verification;
  if (const auto done = findDeepest(**playback, results.deepest); !done) return done.error();
  const auto passed = findPassedStop(file, **playback);
  if (!passed) return passed.error();
  results.passedStop = *passed;
  haptics::Snapshot last{};
  if (const auto done = (*playback)->show((*playback)->ticks() - 1, last); !done)
    return done.error();
  results.last = last.output;
  results.anatomy = (*playback)->anatomy();
  results.contacts = contactPositions(*results.anatomy, results.scenario.array(), results.deepest);
  return results;
}

}  // namespace perilymph::analysis
