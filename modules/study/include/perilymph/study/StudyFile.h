// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The SQLite files of a study: one per shard while it runs, one with everything at the end.
//
// Tables, with SI units unless the name says another:
//   meta(key, value)        title, study (its text), fingerprint, program, cases, first, end
//   insertion(number, ...)  one row per insertion; `settings` is JSON, scenario key: value
//   profile(number, depth_mm, force_mN)          if the study keeps force profiles
//   contact(number, contact, angle_deg, depth_mm, to_modiolus_mm, frequency_Hz)   if it keeps them
// Views, one per question (StudyViews.cpp): setting, ending_by_setting, outcome_by_setting,
// outcome_by_size, extreme.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "perilymph/analysis/FullInsertion.h"
#include "perilymph/database/Database.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/study/Study.h"

namespace perilymph::study {

/// One insertion with what it was.
struct StudyResult {
  std::size_t number = 0;
  std::string cochlea;
  session::Overrides settings;
  double a_mm = 0.0, b_mm = 0.0;      ///< Diameters of the basal turn of the cochlea as built.
  double scalaLength_mm = 0.0;        ///< Length of its scala tympani along the organ of Corti.
  analysis::FullInsertion insertion;  ///< Contacts and profile empty unless they are kept.
};

/// Identity of a file.
struct StudyFileFacts {
  std::string title, text, fingerprint, program;
  std::size_t cases = 0;           ///< Number of insertions of the whole study.
  std::size_t first = 0, end = 0;  ///< Cases that this file is for: first to end - 1.
};
/// Those of a study run by this program.
StudyFileFacts factsOf(const Study& study, std::size_t first, std::size_t end);

/// An open file.
class StudyFile {
public:
  /// Creates an empty file. Refuses one that exists.
  static Result<StudyFile> create(const std::filesystem::path& file, const StudyFileFacts& facts);
  /// Opens a file to go on: whole transactions that were written before are there.
  static Result<StudyFile> resume(const std::filesystem::path& file);
  static Result<StudyFile> open(const std::filesystem::path& file);

  const StudyFileFacts& facts() const noexcept { return facts_; }
  /// Number of insertions in the file; they are first, first + 1, ... An error if they are not.
  Result<std::size_t> size() const;

  /// Adds results in one transaction: all are in the file afterwards, or none.
  Result<Done> append(const std::vector<StudyResult>& results);
  /// Ends writing: the file is then one file, without companions.
  Result<Done> close();

  /// Which part of the insertions is read.
  enum class Part { whole, withoutContactsAndProfile };
  /// Calls `each` with every insertion, in order.
  Result<Done> read(const std::function<Result<Done>(const StudyResult&)>& each,
                    Part part = Part::whole) const;

private:
  explicit StudyFile(database::Database database) : database_(std::move(database)) {}
  Result<Done> readFacts();

  database::Database database_;
  std::filesystem::path file_;
  StudyFileFacts facts_;
};

}  // namespace perilymph::study
