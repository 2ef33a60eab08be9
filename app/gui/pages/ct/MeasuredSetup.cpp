// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/MeasuredSetup.h"

#include <Eigen/Core>
#include <filesystem>
#include <system_error>

#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PatientSetup.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::gui {

Result<anatomy::Patient> patientOfMeasures(const ct::CochleaMeasures& measures, const QString& code)
{
  anatomy::Patient named = imaging::measuredPatient(measures);
  named.label = code.toStdString();
  // each ear of a patient has a file of its own
  const auto file = libraryFileOf(named);
  std::error_code ignored;  // an error is reported when the file is written
  std::filesystem::create_directories(file.parent_path(), ignored);
  const auto text = imaging::measuredPatientText(measures, named.label);
  if (!text) return text.error();
  const auto measured = anatomy::patientIn(*text, file.string());
  if (!measured) return measured.error();
  session::VersionFacts facts{nowUtc(), *text, {}, anatomy::unusualMeasures(*measured)};
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
  if (const auto saved = session::savePatientVersion(*measured, file, facts,
                                                     !findSavedPatient(named.label, named.side));
      !saved)
    return saved.error();
  // the scenario carries the measures and not the path of the file
  return anatomy::loadPatient(file);
}

Result<Setup> setupOfMeasures(const ct::CochleaMeasures& measures, const QString& code)
{
  const auto patient = patientOfMeasures(measures, code);
  if (!patient) return patient.error();
  return setupOfPatient(*patient);
}

}  // namespace perilymph::gui
