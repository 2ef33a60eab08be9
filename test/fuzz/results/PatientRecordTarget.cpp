// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes what is kept of a patient besides the measures, alone and in a patient that is imported.

#include "InputFile.h"
#include "Seeds.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::fuzz {

std::vector<Bytes> seeds()
{
  const InputFile place("none");
  const auto patient = place.folder() / "P-017-left.toml";
  session::PatientRecord record{{"revision", "EAS"},
                                "Second look.\nRound window narrow.",
                                true,
                                {{std::string(64, 'a'), "2026-11-20T09:30:00Z"}}};
  record.markups = {{std::string(64, 'a'),
                     0.2 * Eigen::Matrix3d::Identity(),
                     {{ct::MarkupKind::angle, {{1, 2, 3}, {4, 5, 6}, {7, 8, 8}}},
                      {ct::MarkupKind::note, {{1.5, -2, 30.25}}, "high jugular bulb"}}}};
  promise(static_cast<bool>(session::savePatientRecord(record, patient)), "a record can be kept");
  return {contentOf(session::recordFileOf(patient))};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("record.json"), library("none");
  const auto& place = file.holding({data, size});
  // The measures of the exported patient are valid: the target "patient" fuzzes them.
  anatomy::Patient patient;
  patient.label = "P-017";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
  const auto exported = file.folder() / "patient.toml";
  fuzz::promise(static_cast<bool>(anatomy::savePatient(patient, exported)), "a patient is kept");

  const auto record = session::loadPatientRecord(file.folder() / "record.toml");
  fuzz::promise(place.extension() == ".json", "the record of record.toml");
  library.holding({});
  const auto imported = session::importPatient(file.folder(), library.folder() / "patients",
                                               library.folder() / "recordings");
  if (!record) {
    fuzz::promise(!record.error().message.empty(), "a refusal has a sentence");
    fuzz::promise(!imported && !imported.error().message.empty(), "it is not imported");
    return 0;
  }
  fuzz::promise(static_cast<bool>(session::checkRecord(*record)), "an accepted record is possible");
  fuzz::promise(static_cast<bool>(imported), "a patient with a possible record is imported");
  const auto again = session::loadPatientRecord(*imported);
  fuzz::promise(again && again->tags.size() == record->tags.size() &&
                    again->scans.size() == record->scans.size() &&
                    again->isArchived == record->isArchived && again->markups == record->markups,
                "an imported record is kept");
  return 0;
}
