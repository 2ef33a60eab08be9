// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Playback.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>

#include "MakeEngine.h"
#include "ReplayPass.h"

namespace perilymph::session {

namespace {

using haptics::InsertionEngine;

// A state of 100 nodes takes some tenths of a megabyte: at most a thousand are kept; for a short
// recording one every 100 ticks, which take some milliseconds to compute.
constexpr std::uint64_t maxStates = 1000;
constexpr std::uint64_t fewestBetween = 100;

constexpr std::uint64_t maxSamples = 4000;

}  // namespace

struct Playback::Content {
  Content(std::filesystem::path place, RecordedInsertion opened, Scenario read)
      : file(std::move(place)), recorded(std::move(opened)), scenario(std::move(read))
  {
  }

  Result<void> survey();
  void keep(const InsertionEngine& engine, std::uint64_t computed);
  std::shared_ptr<const InsertionEngine> stateBefore(std::uint64_t computed,
                                                     std::uint64_t& place) const;

  std::filesystem::path file;
  RecordedInsertion recorded;
  Scenario scenario;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  std::shared_ptr<const mechanics::InsertionModel> model;
  std::uint64_t firstTick = 0, ticks = 0, beginning = 0;
  std::uint64_t between = fewestBetween;
  std::vector<Sample> samples;

  /// By number of computed ticks; the first has none.
  mutable std::mutex mutex;
  std::map<std::uint64_t, std::shared_ptr<const InsertionEngine>> states;
  std::uint64_t computed = 0;

  // Used by the thread that calls show()
  std::unique_ptr<InsertionEngine> shown;
  std::uint64_t shownTicks = 0;  ///< Ticks computed by it.
};

Result<void> Playback::Content::survey()
{
  const std::uint64_t rows = recorded.ticks();
  const std::uint64_t step = std::max<std::uint64_t>(1, rows / maxSamples);
  bool hasBegun = false;
  haptics::PeakForce peak;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    if (ticks == 0) firstTick = record.tick;
    if (record.tick != firstTick + ticks) return false;
    if (!hasBegun && record.output.time > 0.0) {
      hasBegun = true;
      beginning = ticks;
    }
    peak.follow(record.output);
    if (ticks % step == 0) samples.push_back({ticks, record.output, peak});
    ++ticks;
    return true;
  });
  if (!read) return read.error();
  if (ticks == 0)
    return Error{"%1 contains no samples and cannot be replayed: the insertion was never started.",
                 file};
  between = std::max(fewestBetween, ticks / maxStates);
  return {};
}

void Playback::Content::keep(const InsertionEngine& engine, std::uint64_t done)
{
  auto copy = done % between == 0 ? std::make_shared<const InsertionEngine>(engine) : nullptr;
  const std::lock_guard lock(mutex);
  computed = done;
  if (copy) states[done] = std::move(copy);
}

std::shared_ptr<const InsertionEngine> Playback::Content::stateBefore(std::uint64_t wanted,
                                                                      std::uint64_t& place) const
{
  const std::lock_guard lock(mutex);
  auto after = states.upper_bound(wanted);
  --after;  // the initial state is always present
  place = after->first;
  return after->second;
}

Playback::Playback() = default;
Playback::~Playback() = default;

Result<std::unique_ptr<Playback>> Playback::open(const std::filesystem::path& file)
{
  auto recorded = RecordedInsertion::open(file);
  if (!recorded) return recorded.error();
  auto scenario = parseScenario(recorded->facts().scenarioText, file.string());
  if (!scenario) return scenario.error();
  std::unique_ptr<Playback> playback(new Playback);
  playback->content_ = std::make_unique<Content>(file, *std::move(recorded), *std::move(scenario));
  Content& content = *playback->content_;
  if (const auto done = content.survey(); !done) return done.error();
  auto anatomy = buildAnatomy(content.scenario);
  if (!anatomy) return anatomy.error();
  content.anatomy = *anatomy;
  auto model = buildModel(content.scenario, content.anatomy);
  if (!model) return model.error();
  content.model = *model;
  auto engine =
      makeEngine(content.scenario.parameters(), content.model, content.recorded.facts().run);
  if (!engine) return engine.error();
  content.states[0] = std::make_shared<const InsertionEngine>(**engine);
  content.shown = *std::move(engine);
  return playback;
}

const std::filesystem::path& Playback::file() const noexcept { return content_->file; }

const RecordingFacts& Playback::facts() const noexcept { return content_->recorded.facts(); }

const Scenario& Playback::scenario() const noexcept { return content_->scenario; }

std::shared_ptr<const anatomy::ScalaTympani> Playback::anatomy() const noexcept
{
  return content_->anatomy;
}

std::uint64_t Playback::ticks() const noexcept { return content_->ticks; }

double Playback::timeStep() const noexcept { return content_->model->timeStep; }

std::uint64_t Playback::beginning() const noexcept { return content_->beginning; }

const std::vector<Playback::Sample>& Playback::samples() const noexcept
{
  return content_->samples;
}

Result<Verification> Playback::compute(const std::stop_token& stop)
{
  Content& content = *content_;
  // A separate connection: the other thread reads concurrently.
  const auto recorded = RecordedInsertion::open(content.file);
  if (!recorded) return recorded.error();
  auto engine = makeEngine(content.scenario.parameters(), content.model, recorded->facts().run);
  if (!engine) return engine.error();
  auto begun = beginVerification(*recorded);
  if (!begun) return begun.error();
  Verification verification = *std::move(begun);
  for (const Sentence& note : whatChanged(*recorded, content.scenario, *content.model))
    verification.notes.push_back(note);
  std::uint64_t done = 0;
  const auto passed = replayThrough(*recorded, **engine, verification, [&] {
    content.keep(**engine, ++done);
    return !stop.stop_requested();
  });
  if (!passed) return passed.error();
  if (stop.stop_requested()) return Error{"Stopped after %1 of %2 ticks.", done, content.ticks};
  return verification;
}

std::uint64_t Playback::computedTicks() const noexcept
{
  const std::lock_guard lock(content_->mutex);
  return content_->computed;
}

Result<void> Playback::show(std::uint64_t place, haptics::Snapshot& picture)
{
  Content& content = *content_;
  const std::uint64_t wanted = std::min(place, content.ticks - 1) + 1;  // number of ticks to
                                                                        // compute
  std::uint64_t kept = 0;
  const auto state = content.stateBefore(wanted, kept);
  if (content.shownTicks > wanted || content.shownTicks < kept) {
    *content.shown = *state;
    content.shownTicks = kept;
  }
  std::optional<haptics::TickRecord> newest;
  const std::uint64_t from = content.shownTicks < wanted ? content.shownTicks : wanted - 1;
  const auto read = content.recorded.forEach(
      [&](const haptics::TickRecord& record) {
        newest = record;
        if (content.shownTicks < wanted) {
          static_cast<void>(content.shown->tick(record.sample, record.commands));
          ++content.shownTicks;
        }
        return content.shownTicks < wanted;
      },
      content.firstTick + from);
  if (!read) return read.error();
  content.shown->fill(picture);
  if (newest) {
    picture.tick = newest->tick;
    picture.output = newest->output;
  }
  return {};
}

}  // namespace perilymph::session
