// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportContent.h"

#include <QCryptographicHash>
#include <QFile>
#include <stop_token>
#include <utility>

#include "gui/setup/KeyImage.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PlannedForces.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/RecordedResults.h"
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
  auto results = analysis::recordedResults(file, stop);
  if (!results) return results.error();
  content.insertion = std::move(results->insertion);
  content.scenario = std::move(results->scenario);
  content.verification = std::move(results->verification);
  content.anatomy = std::move(results->anatomy);
  content.deepest = results->deepest;
  content.last = results->last;
  content.contacts = std::move(results->contacts);
  content.passedStop = results->passedStop;
  if (const auto score = analysis::scoreOf(content.insertion)) content.score = *score;
  if (const auto inVitro = analysis::shippedReference("in-vitro"))
    if (const auto* rupture = inVitro->findRange("rupture of the partition"))
      content.rupture = *rupture;
  if (content.hasPatient()) content.measured = savedPatientOf(content.scenario.patient());
  content.plan = newestPlannedForce(content.scenario);
  const anatomy::Cochlea& cochlea = content.scenario.parameters().cochlea;
  content.measures = analysis::measure(*content.anatomy, cochlea);
  const auto bands = analysis::errorBands(cochlea, content.measures);
  if (bands) content.bands = *bands;
  return content;
}

}  // namespace perilymph::gui
