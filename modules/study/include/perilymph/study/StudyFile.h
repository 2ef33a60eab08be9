// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The SQLite files of a study: one per shard while it runs, one with everything at the end
// (session::InsertionTable).
//
// Tables, with SI units unless the name says another:
//   meta(key, value)        title, study (its text), fingerprint, program, cases, first, end, notes
//                           (where there are any, one a line), files (Study::fileValues() as
//                           JSON, where there are any), and the seal over everything
//   insertion(number, ...)  one row per insertion; `settings` is JSON, scenario key: value
//   profile(number, depth_mm, force_mN)          if the study keeps force profiles
//   contact(number, contact, angle_deg, depth_mm, to_modiolus_mm, frequency_Hz)   if it keeps them
// Views, one per question (StudyViews.cpp): file_value, setting, ending_by_setting, distribution_by_setting,
// outcome_by_setting, outcome_by_size, extreme.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/InsertionTable.h"
#include "perilymph/study/Study.h"

namespace perilymph::study {

/// One insertion with what it was.
struct StudyResult {
  std::size_t number = 0;
  std::string cochlea;
  session::Overrides settings;
  double a_mm = 0.0, b_mm = 0.0;     ///< Diameters of the basal turn of the cochlea as built.
  double scalaLength_mm = 0.0;       ///< Length of its scala tympani along the organ of Corti.
  analysis::InsertionRun insertion;  ///< Contacts and profile empty unless they are kept.

  /// Cochlear duct length from A and B, as on every page (anatomy's DuctLength.h); 0 without them.
  double ductLength_mm() const;
};

/// Identity of a file.
struct StudyFileFacts {
  std::string title, text;
  std::string fingerprint;  ///< Empty of a file that was changed after the program wrote it.
  std::string program;
  std::size_t cases = 0;                ///< Number of insertions of the whole study.
  std::size_t first = 0, end = 0;       ///< Cases that this file is for: first to end - 1.
  std::vector<std::string> notes = {};  ///< On its patients (Study::notes()).
  std::vector<StudyFileValue> fileValues = {};
  Seal seal = Seal::intact;  ///< State of the file that they were read from.
};
/// Those of a study run by this program.
StudyFileFacts factsOf(const Study& study, std::size_t first, std::size_t end);

/// An open file.
class StudyFile {
public:
  /// Opens a file to resume it, or creates it: whole blocks that were written before are there. Refuses a
  /// file with other facts, one that was changed, and one that another program works on.
  static Result<StudyFile> openToContinue(const std::filesystem::path& file,
                                          const StudyFileFacts& facts);
  /// Opens a file and checks it whole. Refuses insertions that are not first, first + 1, ... and
  /// values that no insertion has.
  static Result<StudyFile> open(const std::filesystem::path& file);
  /// The facts of a file and its number of insertions, without a look at their values.
  static Result<std::pair<StudyFileFacts, std::size_t>> outlineOf(
      const std::filesystem::path& file);

  const StudyFileFacts& facts() const noexcept { return facts_; }
  /// Number of insertions in the file; they are first, first + 1, ...
  std::size_t size() const noexcept { return table_.size(); }

  /// Adds results in one transaction: all are in the file afterwards, or none.
  Result<void> append(const std::vector<StudyResult>& results);
  /// Ends writing: the file is then one file, without companions.
  Result<void> close() { return table_.close(); }

  /// Calls `each` with every insertion, in order.
  Result<void> read(const std::function<Result<void>(const StudyResult&)>& each) const;

private:
  StudyFile(session::InsertionTable table, StudyFileFacts facts)
      : table_(std::move(table)), facts_(std::move(facts))
  {
  }

  session::InsertionTable table_;
  StudyFileFacts facts_;
};

}  // namespace perilymph::study
