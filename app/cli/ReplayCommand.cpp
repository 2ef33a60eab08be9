// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <optional>

#include "Commands.h"
#include "RecordingThumbnail.h"
#include "Terminal.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/ContactsCsv.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/Playback.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/TickTable.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/charts/FigurePicture.h"
#endif

namespace perilymph::cli {

namespace {

Result<void> writeRows(const session::RecordedInsertion& recorded, const std::string& csv)
{
  std::optional<Error> failed;
  const auto written = writeWhole(csv, [&](const std::filesystem::path& place) {
    std::ofstream stream(place, std::ios::binary);
    stream << session::csvHeader();
    const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
      stream << session::csvRow(record);
      return stream.good();
    });
    if (!read) failed = read.error();
    stream.close();
    return stream.good() && !failed;
  });
  if (failed) return *failed;
  return written;
}

Result<analysis::ForceProfile> profileOf(const session::RecordedInsertion& recorded)
{
  analysis::ForceProfiler profiler;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    profiler.add(record);
    return true;
  });
  if (!read) return read.error();
  return profiler.profile();
}

void printContent(const session::RecordedInsertion& recorded, const analysis::ForceProfile& profile)
{
  const session::RecordingFacts& facts = recorded.facts();
  print("{}, recorded {} by {} ({})\n", facts.scenarioName, facts.startedUtc, facts.buildId,
        facts.device);
  print("{:18} {}, lost {}, {}\n", "samples", profile.ticks, recorded.lostRecords(),
        recorded.wasClosed()        ? "closed properly"
        : recorded.isBeingWritten() ? "still being recorded"
                                    : "not closed: interrupted");
  print("{:18} {} mN at {} mm travel\n", "peak force", fixed(1e3 * profile.peak.force, 1),
        fixed(inMillimeters(meters(profile.peak.travel)), 1));
  print("{:18} travel {} mm, insertion depth {} mm\n", "at the end",
        fixed(inMillimeters(meters(profile.finalTravel)), 2),
        fixed(inMillimeters(meters(profile.finalDepth)), 2));
}

Result<void> verifyBits(const std::string& file)
{
  const auto verification = session::verify(file);
  if (!verification) return verification.error();
  for (const std::string& note : verification->notes) print("{}\n", note);
  if (!verification->damage.empty())
    return Error{file + " does not contain what was recorded: " + verification->damage +
                 ". Use another copy of the recording."};
  if (verification->isIdentical) {
    print("Replay verified: {} samples identical.\n", verification->ticksCompared);
    return {};
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
  if (!verification->otherVersion.empty())
    return Error{file + " was computed by version " + verification->otherVersion +
                 "; not recomputed: this version, " + version() +
                 ", computes other values from tick " + std::to_string(difference.tick) + " (" +
                 difference.field +
                 ") on. What was recorded is shown, compared and exported as it is."};
  std::string sentence = file + " differs from its replay first at tick " +
                         std::to_string(difference.tick) + " in " + difference.field +
                         ": recorded " + difference.recorded + ", computed " + difference.computed +
                         ".";
  if (!verification->notes.empty()) sentence += " " + verification->notes.front();
  return Error{sentence};
}

/// Recomputes the insertion up to its maximum depth, and writes its contacts there.
Result<void> writeContacts(const session::RecordedInsertion& recorded, const std::string& file,
                           const std::string& csv)
{
  std::uint64_t place = 0, deepest = 0;
  double depth = 0.0;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    if (record.output.depth > depth) {
      depth = record.output.depth;
      deepest = place;
    }
    ++place;
    return true;
  });
  if (!read) return read.error();
  const auto playback = session::Playback::open(file);
  if (!playback) return playback.error();
  haptics::Snapshot shape{};
  if (const auto done = (*playback)->show(deepest, shape); !done) return done.error();
  const session::Scenario& scenario = (*playback)->scenario();
  const auto table = planning::insertionContactsCsv(
      scenario.arrayName(), scenario.array(),
      analysis::contactPositions(*(*playback)->anatomy(), scenario.array(), shape));
  if (!table) return table.error();
  return writeWhole(csv, *table);
}

Result<void> writeThumbnail([[maybe_unused]] const analysis::ForceProfile& profile,
                            const ReplayOptions& options)
{
#if PERILYMPH_HAS_TOOLKIT
  std::error_code ignored;
  if (const auto status = std::filesystem::status(options.thumbnail, ignored);
      std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return Error{"%1 is not a file. Name one for the picture.", options.thumbnail};
  constexpr double pixelsPerPoint = 3.0;  // of writePicture()
  return charts::writePicture(thumbnailOf(profile, options.size_px / pixelsPerPoint),
                              options.thumbnail);
#else
  return Error{"This build has no VTK, which draws %1. Leave --thumbnail out.", options.thumbnail};
#endif
}

/// Restricts a recording that cannot be read to its end to the ticks before the damage.
///
/// @return  What is missing, as an error for after the exports; none if no tick can be read.
std::optional<Error> keepSoundPart(session::RecordedInsertion& recorded)
{
  std::uint64_t last = 0, ticks = 0;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    last = record.tick;
    return ++ticks > 0;
  });
  if (read || ticks == 0) return std::nullopt;
  recorded.endAfter(last);
  return Error{
      "%1 The %2 samples up to tick %3 can be read and were used; those after it are lost.",
      std::string(read.error().message), ticks, last};
}

}  // namespace

Result<void> replay(const ReplayOptions& options)
{
  auto recorded = session::RecordedInsertion::open(options.file);
  if (!recorded) return recorded.error();
  Result<void> doubt;
  if (!options.verifies) {  // verifyBits() checks it itself, and prints the note
    if (!recorded->note().empty()) printError("{}\n", recorded->note());
    if (const auto check = recorded->check(); !check) {
      const auto sound = keepSoundPart(*recorded);
      if (!sound) return check.error();
      doubt = *sound;
    } else if (!check->damage.empty()) {
      doubt = Error{noteOn(*check, options.file)};
    } else if (const std::string note = noteOn(*check, options.file); !note.empty()) {
      printError("{}\n", note);
    }
  }
  if (!options.csv.empty())
    if (const auto done = writeRows(*recorded, options.csv); !done) return done.error();
  if (!options.sqlite.empty())
    if (const auto done = session::writeTickTable(*recorded, options.sqlite); !done)
      return done.error();
  if (!options.contacts.empty())
    if (const auto done = writeContacts(*recorded, options.file, options.contacts); !done)
      return done.error();
  if (options.verifies && options.thumbnail.empty()) return verifyBits(options.file);
  const auto profile = profileOf(*recorded);
  if (!profile) return profile.error();
  if (!options.thumbnail.empty())
    if (const auto done = writeThumbnail(*profile, options); !done) return done.error();
  if (options.verifies) return verifyBits(options.file);
  printContent(*recorded, *profile);
  return doubt;
}

}  // namespace perilymph::cli
