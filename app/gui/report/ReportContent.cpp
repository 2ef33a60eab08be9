// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportContent.h"

#include <QCryptographicHash>
#include <QFile>
#include <algorithm>
#include <iterator>
#include <stop_token>

#include "gui/setup/KeyImage.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PlannedForces.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/session/Playback.h"
#include "perilymph/session/RecordedInsertion.h"

namespace perilymph::gui {

namespace {

QString sha256Of(const std::filesystem::path& path)
{
  QFile file(QString::fromStdString(path.string()));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file)) return {};
  return QString::fromLatin1(hash.result().toHex());
}

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
Result<std::optional<analysis::PassedStop>> findPassedStop(
    const session::RecordedInsertion& recorded, session::Playback& playback)
{
  using Found = std::optional<analysis::PassedStop>;
  const auto hand = analysis::shippedHand();
  if (!hand) return hand.error();
  const session::Scenario& scenario = playback.scenario();
  const auto stop = analysis::stopToPass(scenario.parameters(), *hand);
  if (!stop) return Found();
  std::uint64_t place = 0;
  bool isPassed = false;
  const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
    isPassed = haptics::raisesPeak(record.output, stop->si());
    if (!isPassed) ++place;
    return !isPassed;
  });
  if (!read) return read.error();
  if (!isPassed || place >= playback.ticks()) return Found();
  haptics::Snapshot at{};
  if (const auto done = playback.show(place, at); !done) return done.error();
  return Found(analysis::passedStop(*playback.anatomy(), scenario.array(), *stop, at));
}

/// The saved patient of a recording, if it still has the measures of the insertion.
std::optional<anatomy::Patient> savedPatientOf(const anatomy::Patient& patient)
{
  const auto saved = findSavedPatient(patient.label, patient.side);
  if (!saved || keyImageFile(saved->patient) != keyImageFile(patient)) return std::nullopt;
  return saved->patient;
}

}  // namespace

ReportIdentity ReportContent::identity() const
{
  return {"Insertion report", hasPatient() ? codeOf(scenario.patient()) : std::string(),
          anatomy::statedSeries(patient())};
}

Result<ReportContent> gatherReport(const std::filesystem::path& file, const std::stop_token& stop)
{
  ReportContent content;
  content.file = file;
  const auto recorded = session::RecordedInsertion::open(file);
  if (!recorded) return recorded.error();
  content.facts = recorded->facts();
  content.lostRecords = recorded->lostRecords();
  content.wasClosed = recorded->wasClosed();
  std::error_code ignored;
  content.bytes = std::filesystem::file_size(file, ignored);
  content.sha256 = sha256Of(file);
  auto insertion = analysis::readCompared(file, stop);
  if (!insertion) return insertion.error();
  content.insertion = *std::move(insertion);
  if (const auto score = analysis::scoreOf(content.insertion)) content.score = *score;
  if (const auto inVitro = analysis::shippedReference("in-vitro"))
    if (const auto* rupture = inVitro->findRange("rupture of the partition"))
      content.rupture = *rupture;

  const auto playback = session::Playback::open(file);
  if (!playback) return playback.error();
  content.scenario = (*playback)->scenario();
  if (content.hasPatient()) content.measured = savedPatientOf(content.scenario.patient());
  content.plan = newestPlannedForce(content.scenario);
  const auto verification = (*playback)->compute(stop);
  if (!verification) return verification.error();
  content.verification = *verification;
  if (const auto done = findDeepest(**playback, content.deepest); !done) return done.error();
  auto passed = findPassedStop(*recorded, **playback);
  if (!passed) return passed.error();
  content.passedStop = *std::move(passed);
  haptics::Snapshot last{};
  if (const auto done = (*playback)->show((*playback)->ticks() - 1, last); !done)
    return done.error();
  content.last = last.output;

  content.anatomy = (*playback)->anatomy();
  content.contacts =
      analysis::contactPositions(*content.anatomy, content.scenario.array(), content.deepest);
  content.measures = analysis::measure(*content.anatomy);
  const auto bands = analysis::errorBands(content.scenario.parameters().cochlea, content.measures);
  if (bands) content.bands = *bands;
  return content;
}

}  // namespace perilymph::gui
