// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A patient in a library, and what is kept of the patient.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/session/PatientRecord.h"
#include "perilymph/session/Recording.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {

namespace fs = std::filesystem;

inline anatomy::Patient patientWith(double a_mm)
{
  anatomy::Patient patient;
  patient.label = "P-017";
  patient.side = anatomy::Side::left;
  patient.basalTurn = anatomy::BasalTurn{millimeters(a_mm), millimeters(6.7), millimeters(4.0)};
  patient.errors = anatomy::BasalTurnErrors{millimeters(0.1), millimeters(0.2), std::nullopt};
  patient.origin.seriesKey = std::string(64, 'b');
  return patient;
}

inline VersionFacts factsAt(const std::string& utc)
{
  return {utc, {}, {{"RW", {1.5, -2.0, 30.25}, true}}, {"A is unusual."}};
}

class PatientRecords : public testing::Test {
protected:
  void SetUp() override
  {
    for (const char* name : {"patients", "recordings", "other", "others"})
      fs::create_directories(folder_ / name);
    anatomy::Patient patient;
    patient.label = "P-017";
    patient.side = anatomy::Side::left;
    patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
    ASSERT_TRUE(anatomy::savePatient(patient, file_));
  }

  /// A whole recording of no tick.
  static void record(const fs::path& file)
  {
    auto recording = Recording::create(file, {});
    ASSERT_TRUE(recording) << recording.error().message;
    ASSERT_TRUE((*recording)->close());
  }

  /// The files below a folder.
  static std::vector<std::string> filesIn(const fs::path& folder)
  {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), folder).string());
    return names;
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_ / "patients/P-017-left.toml";
  PatientRecord record_{{"revision", "EAS"},
                        "Second look.\nRound window narrow.",
                        true,
                        {{std::string(64, 'a'), "2026-11-20T09:30:00Z"}}};
};

}  // namespace perilymph::session
