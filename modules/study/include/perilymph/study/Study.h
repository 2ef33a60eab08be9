// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A study: which insertions, in which cochleae, and what is kept of them.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::study {

/// One insertion of a study.
struct StudyCase {
  std::size_t number = 0;        ///< From 0.
  std::size_t cochlea = 0;       ///< Index into Study::cochleae().
  session::Overrides overrides;  ///< Values that replace those of the study's scenario.
};

/// A cochlea of a study.
struct StudyCochlea {
  std::string
      name;  ///< "mean", "virtual 17" or the patient's file with " (measures changed by hand)" if so.
  std::string patient;     ///< The patient's file; empty for the others.
  std::uint64_t draw = 0;  ///< Number of the virtual patient from 1; 0 for the others.
};

/// A range from which a scenario's value is drawn.
struct StudyRange {
  std::string key;
  double low = 0.0, high = 0.0;
};

/// What the file that a setting names says, to group insertions by it.
struct StudyFileValue {
  std::string key, value;  ///< The setting: "friction", "frictions/own.toml".
  std::string name;        ///< "array_name", or the scenario's key: "friction_static".
  std::string content;
};

/// A study as read from its file; immutable, as long as checkFiles() holds. Case k depends on the text of the study, its seed and
/// k alone: any part of a study can be run anywhere, in any order.
///
/// Every combination of the lists is run in every cochlea, `samples` times if there are ranges. The
/// ranges are sampled by a Latin hypercube over all cochleae and samples, the same for every
/// combination.
class Study {
public:
  const std::string& title() const noexcept { return title_; }  ///< One line.
  /// The study's file, line by line as read.
  const std::string& text() const noexcept { return text_; }
  /// SHA-256 of the text and of all files it names, 64 hexadecimal digits.
  const std::string& fingerprint() const noexcept { return fingerprint_; }
  std::uint64_t seed() const noexcept { return seed_; }
  const std::vector<StudyCochlea>& cochleae() const noexcept { return cochleae_; }
  const std::vector<StudyRange>& ranges() const noexcept { return ranges_; }
  /// A sentence for each patient whose measures were changed by hand, then for each whose measures
  /// name an origin without a seal.
  const std::vector<std::string>& notes() const noexcept { return notes_; }
  /// The name of each varied array and the coefficients of each varied friction, unless they are settings.
  const std::vector<StudyFileValue>& fileValues() const noexcept { return fileValues_; }
  /// Distance between the points of the force profiles that are kept; 0: none are.
  Length profileSpacing() const noexcept { return profileSpacing_; }
  /// Whether the position of each contact is kept.
  bool keepsContacts() const noexcept { return keepsContacts_; }

  /// Refuses if a file that the study names, such as a patient's, is not as it was read.
  Result<void> checkFiles() const;

  std::size_t casesPerCochlea() const noexcept { return combinations_.size() * samples_; }
  /// Number of insertions.
  std::size_t size() const noexcept { return cochleae_.size() * casesPerCochlea(); }
  /// Case `number`, below size(). All cases of a cochlea are consecutive.
  StudyCase caseAt(std::size_t number) const;

  /// The parameters of a case. The `cochlea` among them is the same for all cases of a cochlea, so
  /// that its anatomy is built once.
  Result<session::InsertionParameters> parametersOf(const StudyCase& one) const;
  /// The same as a scenario, with a text that can be recorded. The diameters of a virtual cochlea
  /// are those of parametersOf(), or the next number that a text in millimeters can state.
  Result<session::Scenario> scenarioOf(const StudyCase& one) const;

private:
  friend class StudyReader;
  Result<session::Scenario> variedScenario(const StudyCase& one) const;

  std::string title_, text_, fingerprint_;
  std::uint64_t seed_ = 1;
  bool isFullDepth_ = true;
  std::vector<StudyCochlea> cochleae_;
  std::vector<std::string> notes_;
  std::vector<StudyFileValue> fileValues_;
  std::map<std::filesystem::path, std::string> files_;  ///< What it names, with their SHA-256.
  std::vector<session::Overrides> combinations_;
  std::vector<session::Scenario> scenarios_;  ///< One per combination, in the scenario's cochlea.
  std::vector<StudyRange> ranges_;
  std::size_t samples_ = 1;
  /// Stratum of each (cochlea, sample) in each range.
  std::vector<std::vector<std::uint32_t>> strata_;
  Length profileSpacing_;
  bool keepsContacts_ = false;
};

/// Maximum number of insertions of a study.
inline constexpr std::size_t maxCases = 10'000'000;

/// Maximum number of combinations of its lists and written cases; each is read as a scenario.
inline constexpr std::size_t maxCombinations = 10'000;

/// Reads a study and checks it whole: every combination is read as a scenario, every range at both
/// ends, every patient. Errors name the file, the key and what is allowed.
Result<Study> loadStudy(const std::filesystem::path& file);
/// The same from its text. Paths in it are of its folder first, then of the working folder.
Result<Study> parseStudy(const std::string& text, const std::filesystem::path& file);

}  // namespace perilymph::study
