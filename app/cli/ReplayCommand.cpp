#include <cstdio>
#include <fstream>
#include <optional>

#include "Commands.h"
#include "OutputFile.h"
#include "Printable.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"

namespace perilymph::cli {

namespace {

Result<Done> writeRows(const session::RecordedInsertion& recorded, const std::string& csv)
{
  std::optional<Error> trouble;
  const auto written = writeWhole(csv, [&](const std::filesystem::path& place) {
    std::ofstream stream(place, std::ios::binary);
    stream << session::csvHeader();
    const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
      stream << session::csvRow(record);
      return stream.good();
    });
    if (!read) trouble = read.error();
    stream.close();
    return stream.good() && !trouble;
  });
  if (trouble) return *trouble;
  return written;
}

Result<Done> printContent(const session::RecordedInsertion& recorded)
{
  analysis::ForceProfiler profiler;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    profiler.add(record);
    return true;
  });
  if (!read) return read.error();
  const session::RecordingFacts& facts = recorded.facts();
  const analysis::ForceProfile profile = profiler.profile();
  std::printf("%s, recorded %s by %s (%s)\n", printable(facts.scenarioName).c_str(),
              printable(facts.startedUtc).c_str(), printable(facts.buildId).c_str(),
              printable(facts.device).c_str());
  std::printf("%-18s %llu, lost %llu, %s\n", "ticks",
              static_cast<unsigned long long>(profile.ticks),
              static_cast<unsigned long long>(recorded.lostRecords()),
              recorded.wasClosed() ? "closed properly" : "not closed: it ends where it broke off");
  std::printf("%-18s %s N at %s mm of travel\n", "peak force", fixed(profile.peak.force, 4).c_str(),
              fixed(inMillimeters(meters(profile.peak.travel)), 1).c_str());
  std::printf("%-18s travel %s mm, depth %s mm\n", "at the end",
              fixed(inMillimeters(meters(profile.finalTravel)), 2).c_str(),
              fixed(inMillimeters(meters(profile.finalDepth)), 2).c_str());
  return Done{};
}

Result<Done> verifyBits(const std::string& file)
{
  const auto verification = session::verify(file);
  if (!verification) return verification.error();
  for (const std::string& note : verification->notes) std::printf("%s\n", printable(note).c_str());
  if (!verification->damage.empty())
    return Error{file + " does not hold what was recorded: " + verification->damage +
                 ". Use another copy of the recording."};
  if (verification->isIdentical) {
    std::printf("%llu ticks replayed, every bit the same.\n",
                static_cast<unsigned long long>(verification->ticksCompared));
    return Done{};
  }
  if (!verification->difference && verification->missingTicks > 0)
    return Error{file + " is verified in part: " + std::to_string(verification->ticksCompared) +
                 " of " + std::to_string(verification->ticks) +
                 " ticks replayed, every bit the same; " +
                 std::to_string(verification->missingTicks) +
                 " ticks were lost while it was recorded, and what follows them cannot be "
                 "compared."};
  if (!verification->difference)
    return Error{file + " holds nothing that could be compared. Record an insertion first."};
  const session::Difference& difference = *verification->difference;
  std::string sentence = file + " differs from its replay first at tick " +
                         std::to_string(difference.tick) + " in " + difference.field +
                         ": recorded " + difference.recorded + ", computed " + difference.computed +
                         ".";
  if (!verification->notes.empty()) sentence += " " + verification->notes.front();
  return Error{sentence};
}

}  // namespace

Result<Done> replay(const ReplayOptions& options)
{
  const auto recorded = session::RecordedInsertion::open(options.file);
  if (!recorded) return recorded.error();
  if (!recorded->note().empty()) std::fprintf(stderr, "%s\n", printable(recorded->note()).c_str());
  if (!options.csv.empty())
    if (const auto done = writeRows(*recorded, options.csv); !done) return done.error();
  if (options.verifies) return verifyBits(options.file);
  return printContent(*recorded);
}

}  // namespace perilymph::cli
