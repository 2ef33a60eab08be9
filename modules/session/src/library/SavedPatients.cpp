// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/SavedPatients.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace perilymph::session {

namespace fs = std::filesystem;

SavedPatients readPatients(const fs::path& folder)
{
  SavedPatients read;
  std::vector<std::pair<fs::file_time_type, SavedPatient>> found;
  std::error_code failure;
  fs::directory_iterator entries(folder, failure);
  if (failure) return read;  // no patient was saved yet
  for (const fs::directory_entry& entry : entries) {
    if (entry.path().extension() != ".toml") continue;
    const auto patient = anatomy::loadPatient(entry.path());
    const auto time = entry.last_write_time(failure);
    if (failure) continue;  // removed meanwhile
    if (!patient) {
      read.unreadable.push_back(patient.error().message);
      continue;
    }
    const auto record = loadPatientRecord(entry.path());
    if (!record) read.unreadable.push_back(record.error().message);
    found.push_back({time, {*patient, entry.path(), record ? *record : PatientRecord()}});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& one, const auto& other) { return one.first > other.first; });
  for (auto& [time, patient] : found) read.patients.push_back(std::move(patient));
  return read;
}

bool haveSameMeasures(const anatomy::Patient& one, const anatomy::Patient& other)
{
  const auto textOf = [](anatomy::Patient patient) {
    patient.origin.software.clear();
    return anatomy::patientText(patient);
  };
  return textOf(one) == textOf(other);
}

}  // namespace perilymph::session
