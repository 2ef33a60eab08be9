// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Replay.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <stop_token>
#include <type_traits>

#include "MakeEngine.h"
#include "ReplayPass.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/Csv.h"
#include "recording/TickFields.h"

namespace perilymph::session {

namespace {

/// One field of an output: name, bits and display text.
struct FieldValue {
  const char* name;
  int index;
  std::uint64_t bits;
  double value;

  std::string fullName() const
  {
    return index < 0 ? name : std::string(name) + '[' + std::to_string(index) + ']';
  }
  std::string text() const
  {
    char hexadecimal[32];
    std::snprintf(hexadecimal, sizeof hexadecimal, " (bits %016llx)",
                  static_cast<unsigned long long>(bits));
    return shortestDecimal(value) + hexadecimal;
  }
};

void flatten(const haptics::TickOutput& output, std::vector<FieldValue>& fields)
{
  fields.clear();
  forEachField(output, [&fields](const char* name, int index, const auto& value) {
    using Field = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Field, double>)
      fields.push_back({name, index, std::bit_cast<std::uint64_t>(value), value});
    else
      fields.push_back(
          {name, index, static_cast<std::uint64_t>(value), static_cast<double>(value)});
  });
}

/// Compares outputs, reusing the memory of their fields.
class Comparison {
public:
  std::optional<Difference> difference(const haptics::TickRecord& recorded,
                                       haptics::TickOutput computed)
  {
    // what an earlier version did not record is not compared
    if (std::isnan(recorded.output.partitionForce))
      computed.partitionForce = recorded.output.partitionForce;
    if (std::isnan(recorded.output.plasticWork))
      computed.plasticWork = recorded.output.plasticWork;
    else if (std::isnan(computed.plasticWork))
      computed.plasticWork = 0.0;  // the array's file gave a yield stress once
    flatten(recorded.output, recorded_);
    flatten(computed, computed_);
    for (std::size_t i = 0; i < recorded_.size(); ++i)
      if (recorded_[i].bits != computed_[i].bits)
        return Difference{recorded.tick, recorded_[i].fullName(), recorded_[i].text(),
                          computed_[i].text()};
    return std::nullopt;
  }

private:
  std::vector<FieldValue> recorded_, computed_;
};

}  // namespace

std::vector<Sentence> whatChanged(const RecordedInsertion& recorded, const Scenario& scenario,
                                  const mechanics::InsertionModel& model)
{
  const RecordingFacts& facts = recorded.facts();
  std::vector<Sentence> notes;
  if (!recorded.note().empty()) notes.push_back(recorded.note());
  if (!recorded.wasClosed() && !recorded.isBeingWritten())
    notes.push_back(
        Sentence{"The recording was not closed: it ends where the program was interrupted."});
  if (facts.buildId != buildId())
    notes.push_back(
        Sentence{"Recorded by build %1, replayed by build %2.", facts.buildId, buildId()});
  if (scenario.expectedArrayFingerprint() != scenario.arrayFingerprint())
    notes.push_back(Sentence{"The file of the array '%1' has changed since the recording was made.",
                             scenario.arrayName()});
  if (!model.hasFingerprint(facts.modelFingerprint))
    notes.push_back(
        Sentence{"The model built from the recorded scenario differs from the recorded model."});
  return notes;
}

Result<Verification> beginVerification(const RecordedInsertion& recorded)
{
  const auto checked = recorded.check();
  if (!checked) return checked.error();
  Verification verification;
  if (recorded.facts().version != version()) verification.otherVersion = recorded.facts().version;
  verification.ticks = checked->ticks;
  verification.missingTicks = checked->missingTicks;
  verification.damage = checked->damage;
  if (!checked->hasHash)
    verification.notes.push_back(
        Sentence{"Recorded in format 1, which has no hash: that nothing was changed is shown by "
                 "counts, columns, events and the replay alone."});
  if (checked->ticks == 0)
    verification.notes.push_back(Sentence{"The recording contains no samples."});
  return verification;
}

Result<void> replayThrough(const RecordedInsertion& recorded, haptics::InsertionEngine& engine,
                           Verification& verification, const std::function<bool()>& after)
{
  Comparison comparison;
  std::optional<std::uint64_t> last;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    if (last && record.tick != *last + 1) {
      verification.notes.push_back(
          Sentence{"%1 ticks before tick %2 were lost; nothing after them can be compared.",
                   record.tick - *last - 1, record.tick});
      return false;
    }
    last = record.tick;
    const haptics::TickOutput computed = engine.tick(record.sample, record.commands);
    if (!verification.difference) {
      ++verification.ticksCompared;
      verification.difference = comparison.difference(record, computed);
    }
    return after();
  });
  if (!read) return read.error();
  verification.isIdentical = verification.damage.empty() && !verification.difference &&
                             verification.ticks > 0 &&
                             verification.ticksCompared == verification.ticks;
  return {};
}

Result<Verification> verify(const std::filesystem::path& file, const VerifyProgress& progress,
                            const std::stop_token& stop)
{
  std::uint64_t done = 0;
  std::uint64_t all = 0;
  const auto recorded = RecordedInsertion::open(file, stop);
  if (!recorded) return recorded.error();
  auto verification = beginVerification(*recorded);
  if (!verification || !verification->damage.empty()) return verification;
  all = verification->ticks;

  const RecordingFacts& facts = recorded->facts();
  const auto scenario = parseScenario(facts.scenarioText, file.string());
  if (!scenario) return scenario.error();
  const auto anatomy = buildAnatomy(*scenario);
  if (!anatomy) return anatomy.error();
  const auto model = buildModel(*scenario, *anatomy);
  if (!model) return model.error();
  auto engine = makeEngine(scenario->parameters(), *model, facts.run);
  if (!engine) return engine.error();
  for (const Sentence& note : whatChanged(*recorded, *scenario, **model))
    verification->notes.push_back(note);
  const auto passed = replayThrough(*recorded, **engine, *verification, [&] {
    ++done;
    if (progress) progress(done, all);
    return !stop.stop_requested() && !verification->difference;
  });
  if (!passed) return passed.error();
  if (stop.stop_requested())
    return Error{"Stopped after %1 of %2 ticks; %3 is not verified.", done, all, file};
  return verification;
}

}  // namespace perilymph::session
