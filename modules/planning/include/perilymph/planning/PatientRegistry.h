// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The saved patients as a table for registries: a row for each ear, with measures, newest plan and newest
// insertion.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::planning {

/// Where patients, plans and recordings are.
struct RegistryFolders {
  std::filesystem::path patients, plans, recordings;
  std::filesystem::path beingRecorded = {};  ///< A recording that is not finished; it is left out.
};

/// Those of this user.
RegistryFolders ownRegistryFolders();

struct PatientRegistry {
  std::string csv;           ///< Columns of registryDictionaryCsv(), rows by code and ear.
  std::size_t patients = 0;  ///< Number of rows.
  /// What could not be read, a sentence each: its fields are empty, an unreadable patient has no row.
  std::vector<Sentence> notes;
};

/// Receives the number of finished and of all patients.
using RegistryProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Makes the table. Values are those of plan.json and of the insertion's report, to six digits; no field
/// has a name, a note, a tag or a path. Each newest insertion is replayed, in about a tenth of its
/// duration. `stop` ends it early, with an error.
Result<PatientRegistry> patientRegistry(const RegistryFolders& folders,
                                        const RegistryProgress& progress = {},
                                        const std::stop_token& stop = {});

/// `column, unit, meaning, source`: a row for each column of the table, in their order.
std::string registryDictionaryCsv();

}  // namespace perilymph::planning
