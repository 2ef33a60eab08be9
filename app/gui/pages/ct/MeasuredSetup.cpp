// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/MeasuredSetup.h"

#include <Eigen/Core>
#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "gui/setup/MeasureVersions.h"
#include "gui/setup/PatientSetup.h"
#include "perilymph/foundation/UtcTime.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::gui {

namespace {

/// Where the cochlea was measured, and what the measurement says of itself.
session::VersionFacts factsOf(const ct::CochleaMeasures& measures, const std::string& text,
                              const anatomy::Patient& patient)
{
  session::VersionFacts facts{utcNow(), text, {}, anatomy::unusualMeasures(patient)};
  for (std::size_t k = 0; k < ct::markCount; ++k)
    if (const auto& point = measures.marksByHand.points_P[k])
      facts.landmarks.push_back(
          {ct::nameOf(static_cast<ct::Mark>(k)), {point->x(), point->y(), point->z()}, true});
  const Eigen::Vector3d& window_P = measures.roundWindow_P;
  if (!measures.marksByHand[ct::Mark::roundWindow])
    facts.landmarks.push_back(
        {ct::nameOf(ct::Mark::roundWindow), {window_P.x(), window_P.y(), window_P.z()}, false});
  for (const ct::Flag flag : measures.flags) facts.warnings.emplace_back(ct::sentenceOf(flag));
  for (Sentence& sentence : ct::landmarkContradictions(measures))
    facts.warnings.push_back(std::move(sentence));
  if (auto note = imaging::heightNote(measures)) facts.warnings.push_back(*std::move(note));
  return facts;
}

/// Saves measures as a version of the ear with this code.
Result<void> saveMeasures(const ct::CochleaMeasures& measures, const std::string& code,
                          const std::filesystem::path& file)
{
  const auto text = imaging::measuredPatientText(measures, code);
  if (!text) return text.error();
  const auto measured = anatomy::patientIn(*text, file.string());
  if (!measured) return measured.error();
  return session::savePatientVersion(*measured, file, factsOf(measures, *text, *measured),
                                     !findSavedPatient(code, measured->side));
}

/// Whether a record has these measures.
bool isKnown(const ct::CochleaMeasures& measures, const std::string& code)
{
  anatomy::Patient patient = imaging::measuredPatient(measures);
  patient.label = code;
  const auto saved = findSavedPatient(code, patient.side);
  return saved && std::ranges::any_of(versionsOf(*saved), [&patient](const MeasureVersion& each) {
           return haveSameMeasures(each.patient, patient);
         });
}

}  // namespace

Result<anatomy::Patient> patientOfMeasures(const ct::CochleaMeasures& measures, const QString& code,
                                           const ct::CochleaMeasures* former)
{
  anatomy::Patient named = imaging::measuredPatient(measures);
  named.label = code.toStdString();
  // each ear of a patient has a file of its own
  const auto file = libraryFileOf(named);
  std::error_code ignored;  // an error is reported when the file is written
  std::filesystem::create_directories(file.parent_path(), ignored);
  if (former != nullptr && former->side == measures.side && !isKnown(*former, named.label))
    if (const auto kept = saveMeasures(*former, named.label, file); !kept) return kept.error();
  if (const auto saved = saveMeasures(measures, named.label, file); !saved) return saved.error();
  // the scenario carries the measures and not the path of the file
  return anatomy::loadPatient(file);
}

Result<Setup> setupOfMeasures(const ct::CochleaMeasures& measures, const QString& code,
                              const anatomy::Approach& approach, const ct::CochleaMeasures* former)
{
  const auto patient = patientOfMeasures(measures, code, former);
  if (!patient) return patient.error();
  auto setup = setupOfPatient(*patient);
  if (!setup) return setup.error();
  auto approached = withApproach(setup->scenario, approach);
  if (!approached) return approached.error();
  setup->scenario = *std::move(approached);
  return setup;
}

}  // namespace perilymph::gui
