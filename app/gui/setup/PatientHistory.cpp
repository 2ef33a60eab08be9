// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PatientHistory.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <map>
#include <stop_token>

#include "gui/setup/OutcomeWords.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/outcome/OutcomeText.h"

namespace perilymph::gui {

namespace {

constexpr std::size_t shownDigits = 12;  // of a hash

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text, const char* of = nullptr)
{
  return QCoreApplication::translate("perilymph::gui", text, of);
}

bool isOf(const anatomy::Patient& patient, const std::string& code, anatomy::Side side)
{
  return patient.label == code && patient.side == side;
}

/// The series, with the landmarks of the newest measures that were taken in it.
CtRequest requestOf(const SavedPatient& patient, const std::string& series)
{
  CtRequest request{QString::fromStdString(patient.patient.label), series};
  request.side = patient.patient.side;
  for (const session::PatientVersion& each : patient.record.versions) {
    const auto measured = anatomy::patientIn(each.patient, patient.file.string());
    // one with entered measures has none of its own
    if (measured && statedSeries(*measured) == series && !each.landmarks.empty())
      request.landmarks = each.landmarks;
  }
  return request;
}

HistoryEntry scanEntry(const SavedPatient& patient, const std::string& series,
                       const std::string& utc)
{
  return {HistoryEntry::Kind::scan,
          utc,
          tr("Scan"),
          tr("series %1").arg(QString::fromStdString(series.substr(0, shownDigits))),
          tr("Opens the CT series with the SHA-256 %1 where it was read. The CT itself is not "
             "kept.")
              .arg(QString::fromStdString(series)),
          {},
          requestOf(patient, series)};
}

/// The series that the measures of the patient and of its plans were taken from.
std::vector<HistoryEntry> scansOf(const SavedPatient& patient,
                                  const std::vector<const StoredPlan*>& plans)
{
  std::map<std::string, std::string> first;  // date by series
  const auto add = [&first](const std::string& series, const std::string& utc) {
    if (series.empty()) return;
    std::string& date = first[series];
    if (date.empty() || (!utc.empty() && utc < date)) date = utc;
  };
  for (const session::PatientScan& scan : patient.record.scans) add(scan.series, scan.savedUtc);
  for (const StoredPlan* plan : plans) add(statedSeries(plan->request.patient), plan->madeUtc);
  add(statedSeries(patient.patient), {});
  std::vector<HistoryEntry> entries;
  for (const auto& [series, utc] : first) entries.push_back(scanEntry(patient, series, utc));
  return entries;
}

HistoryEntry planEntry(const StoredPlan& plan)
{
  const std::size_t arrays = plan.request.arrays.size();
  QStringList values{arrays == 1 ? tr("1 array") : tr("%1 arrays").arg(arrays)};
  values << (plan.isComplete ? tr("%1 simulations").arg(plan.shownDraws)
                             : tr("%1 simulations so far").arg(plan.shownDraws));
  return {HistoryEntry::Kind::plan,
          plan.madeUtc,
          tr("Plan"),
          values.join(tr(" · ")),
          tr("Opens the plan on the page Plan."),
          plan.folder};
}

HistoryEntry insertionEntry(const session::SessionSummary& session)
{
  const session::Highlights& found = session.highlights;
  const QStringList values{
      QString::fromStdString(session.array),
      tr("depth %1 mm").arg(numberText(inMillimeters(meters(found.deepest)), 1)),
      tr("peak %1 mN").arg(forceNumber(inMillinewtons(newtons(found.peakForce))))};
  return {HistoryEntry::Kind::insertion,
          session.startedUtc,
          tr("Insertion"),
          values.join(tr(" · ")),
          tr("Replays the recording %1.").arg(QString::fromStdString(session.file.string())),
          session.file};
}

HistoryEntry outcomeEntry(const SavedPatient& patient, std::size_t place)
{
  const session::PatientOutcome& saved = patient.record.outcomes[place];
  return {HistoryEntry::Kind::outcome,
          saved.utc,
          tr("Outcome", "of an implanted ear"),
          outcomeWords(saved),
          tr("Opens the outcome on the page Outcome, in its CT where that is still there."),
          patient.file,
          {},
          place};
}

}  // namespace

PatientWork readPatientWork(const std::filesystem::path& beingRecorded, const std::stop_token& stop)
{
  PatientWork work;
  work.plans = storedPlans();
  auto sessions = session::listSessions(sessionFolder(), beingRecorded, {}, {}, stop);
  if (sessions) work.sessions = *std::move(sessions);  // else none was recorded yet
  return work;
}

std::vector<HistoryEntry> historyOf(const SavedPatient& patient, const PatientWork& work)
{
  const anatomy::Patient& one = patient.patient;
  const std::string side = anatomy::nameOf(one.side);
  std::vector<const StoredPlan*> plans;
  for (const StoredPlan& each : work.plans)
    if (isOf(one, each.request.patient.label, each.request.patient.side)) plans.push_back(&each);
  std::vector<HistoryEntry> entries = scansOf(patient, plans);
  for (const StoredPlan* each : plans) entries.push_back(planEntry(*each));
  for (const session::SessionSummary& each : work.sessions)
    if (each.patient == one.label && each.side == side && session::isInsertion(each))
      entries.push_back(insertionEntry(each));
  for (std::size_t place = patient.record.outcomes.size(); place-- > 0;)  // the newest first
    entries.push_back(outcomeEntry(patient, place));
  std::stable_sort(entries.begin(), entries.end(),
                   [](const HistoryEntry& a, const HistoryEntry& b) { return a.utc > b.utc; });
  return entries;
}

QString outcomeWords(const session::PatientOutcome& saved)
{
  const auto content = outcome::outcomeIn(saved.content, "record");
  if (!content) return tr("cannot be read");
  return QStringList{arrayTitle(content->found.array), depthText(content->found)}.join(tr(" · "));
}

QString localTimeText(const std::string& utc)
{
  const auto time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return time.isValid() ? time.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))
                        : QStringLiteral("–");
}

}  // namespace perilymph::gui
