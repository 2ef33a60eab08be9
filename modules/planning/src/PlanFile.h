// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The draws of a plan in a SQLite file, so that a plan can be interrupted and continued.
//
// Tables: meta(key, value) with fingerprint and program; insertion(draw, array, content), the content
// as JSON in SI units, which keeps every bit.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/database/Database.h"
#include "perilymph/planning/Plan.h"

namespace perilymph::planning {

/// An open file of draws.
class PlanFile {
public:
  /// Opens a plan's file to continue, or creates it. Refuses a file of another plan and one of
  /// another build of the program.
  static Result<PlanFile> open(const std::filesystem::path& file, const std::string& fingerprint);
  /// Opens a plan's file for reading only, whatever plan and build it is of.
  static Result<PlanFile> openToView(const std::filesystem::path& file);

  /// What the draws depend on, and the build of the program that made them.
  struct Origin {
    std::string fingerprint, program;
  };
  Result<Origin> origin() const;

  /// The insertions of all whole draws, by draw and array.
  Result<std::vector<PlannedInsertion>> read() const;
  /// Adds whole draws in one transaction: all are in the file afterwards, or none.
  Result<Done> append(const std::vector<PlannedInsertion>& insertions);
  /// Ends writing: the file is then one file, without companions.
  Result<Done> close();

private:
  PlanFile(database::Database database, std::filesystem::path file)
      : database_(std::move(database)), file_(std::move(file))
  {
  }
  Result<Done> check(const std::string& fingerprint) const;

  database::Database database_;
  std::filesystem::path file_;
};

/// An insertion as text of a row, and back; nothing for any other text.
std::string contentOf(const PlannedInsertion& insertion);
std::optional<PlannedInsertion> insertionIn(const std::string& content);

}  // namespace perilymph::planning
