// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an insertion is made of, as people write it down.

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::session {

/// Values that replace a scenario's own: `--set key=value`, `--patient`, `--array`, `--nodes`.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// What a scenario holds. Only loadScenario() and parseScenario() make a Scenario of one.
struct ScenarioContent {
  InsertionParameters parameters;
  std::string title;
  std::string patientName, arrayName = "contour", calibrationName;
  std::string arrayFingerprint, expectedArrayFingerprint;
  Overrides values;
  std::vector<std::filesystem::path> files;
  std::vector<std::string> notes;
  std::string text;
};

/// A scenario as read: its parameters and their text. It is immutable, so that text() always
/// describes what runs; with() reads it again with other values. Keys of the TOML file have the
/// names of the accessors, with units.
class Scenario {
public:
  /// An empty scenario without a text, to be replaced by one that was read.
  Scenario();
  ~Scenario();
  // A copy shares the content; a move is a copy, so that no scenario is ever without content.
  Scenario(const Scenario&);
  Scenario& operator=(const Scenario&);

  const std::string& name() const noexcept { return parameters().name; }
  const std::string& title() const noexcept { return content_->title; }  ///< One line for display.
  /// The scenario as run, TOML, as stored in a recording. It has every value, including the
  /// patient's numbers and the fingerprint of the array's file, so that parseScenario(text) gives
  /// the same model anywhere, bit for bit.
  const std::string& text() const noexcept { return content_->text; }
  /// Every key as run and its value in TOML format (also valid JSON), in order; the patient's are
  /// called "patient_numbers.st_length_mm" and so on.
  const Overrides& values() const noexcept { return content_->values; }
  /// All files it was read from: scenario, patient, array, friction and calibration.
  const std::vector<std::filesystem::path>& files() const noexcept { return content_->files; }
  /// Messages for the user.
  const std::vector<std::string>& notes() const noexcept { return content_->notes; }

  /// The scenario with other values, by the rules of a command line's overrides.
  Result<Scenario> with(const Overrides& overrides) const;

  // --- what it names ---
  const std::string& patientName() const noexcept { return content_->patientName; }  ///< Or empty.
  const std::string& arrayName() const noexcept { return content_->arrayName; }
  /// Name of the array's calibration; empty without one.
  const std::string& calibrationName() const noexcept { return content_->calibrationName; }
  /// Fingerprint of the array's file as read, 16 hexadecimal digits.
  const std::string& arrayFingerprint() const noexcept { return content_->arrayFingerprint; }
  /// The same when this text was written (`array_fingerprint`); empty in files of users.
  const std::string& expectedArrayFingerprint() const noexcept
  {
    return content_->expectedArrayFingerprint;
  }

  // --- what runs ---
  const InsertionParameters& parameters() const noexcept { return content_->parameters; }
  anatomy::AnatomySource anatomy() const noexcept { return parameters().cochlea.source; }
  const anatomy::Patient& patient() const noexcept { return parameters().cochlea.patient; }
  Length leadIn() const noexcept { return parameters().cochlea.leadIn; }
  const electrode::ArrayDesign& array() const noexcept { return parameters().array; }
  Technique technique() const noexcept { return parameters().technique; }
  mechanics::ModelKind model() const noexcept { return parameters().model; }
  int nodes() const noexcept { return parameters().nodes; }
  Duration timeStep() const noexcept { return parameters().timeStep; }
  long seed() const noexcept { return parameters().seed; }
  Speed speed() const noexcept { return parameters().speed; }
  Length startInside() const noexcept { return parameters().startInside; }
  Length stopTravel() const noexcept { return parameters().stopTravel; }
  bool withdraws() const noexcept { return parameters().withdraws; }
  Speed styletSpeed() const noexcept { return parameters().styletSpeed; }
  Angle approachTilt() const noexcept { return parameters().approachTilt; }
  Angle approachTurn() const noexcept { return parameters().approachTurn; }
  const mechanics::FrictionLaw& friction() const noexcept { return parameters().friction; }
  const mechanics::RelaxationLaw& relaxation() const noexcept { return parameters().relaxation; }
  const mechanics::WallLaw& wall() const noexcept { return parameters().wall; }
  OpeningKind openingKind() const noexcept { return parameters().openingKind; }
  const std::optional<mechanics::Opening>& opening() const noexcept { return parameters().opening; }
  MembraneKind membraneKind() const noexcept { return parameters().membraneKind; }
  const std::optional<mechanics::MembraneLaw>& membrane() const noexcept
  {
    return parameters().membrane;
  }
  const haptics::EngineSettings& engine() const noexcept { return parameters().engine; }

private:
  friend Result<Scenario> loadScenario(const std::string&, const Overrides&);
  friend Result<Scenario> parseScenario(const std::string&, const std::string&, const Overrides&);
  explicit Scenario(ScenarioContent content);

  std::shared_ptr<const ScenarioContent> content_;  ///< Never null.
};

/// Reads a scenario by a shipped name or a file's path, with everything it names. A patient and paths of
/// other files are looked for beside the scenario's file, then among the shipped ones and in the working
/// folder; what is given as an override is looked for in the working folder first.
Result<Scenario> loadScenario(const std::string& nameOrFile, const Overrides& overrides = {});
/// The same from a text, such as the one a recording keeps. `name` stands for the file in messages.
Result<Scenario> parseScenario(const std::string& text, const std::string& name,
                               const Overrides& overrides = {});

/// The same overrides with absolute paths, where one gives the path of a file in the folder.
Overrides withFilesIn(const std::filesystem::path& folder, Overrides overrides);

/// The cochlea of an insertion. Takes some tenths of a second.
Result<std::shared_ptr<const anatomy::ScalaTympani>> buildAnatomy(
    const InsertionParameters& parameters);

/// The model of an insertion. Takes milliseconds.
Result<std::shared_ptr<const mechanics::InsertionModel>> buildModel(
    const InsertionParameters& parameters, std::shared_ptr<const anatomy::ScalaTympani> anatomy);

inline Result<std::shared_ptr<const anatomy::ScalaTympani>> buildAnatomy(const Scenario& scenario)
{
  return buildAnatomy(scenario.parameters());
}

inline Result<std::shared_ptr<const mechanics::InsertionModel>> buildModel(
    const Scenario& scenario, std::shared_ptr<const anatomy::ScalaTympani> anatomy)
{
  return buildModel(scenario.parameters(), std::move(anatomy));
}

}  // namespace perilymph::session
