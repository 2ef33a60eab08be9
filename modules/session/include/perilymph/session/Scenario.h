#pragma once

// What an insertion is made of, as people write it down.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::session {

/// A scenario: keys of the same names, with units, in its TOML file.
///
/// `text` holds every value as run, with the patient's numbers and the fingerprint of the array's
/// file, so that parseScenario(text) anywhere gives the same model, bit for bit.
struct Scenario {
  std::string name;
  std::string title;  ///< For people: one line.
  /// By default the one that the patient's numbers build.
  anatomy::AnatomySource anatomy = anatomy::AnatomySource::published;
  anatomy::Patient patient;  ///< From `patient` (a file or a shipped name), else published.
  std::string patientName;   ///< What `patient` said; empty without one.
  std::string arrayName = "contour";
  electrode::ArrayDesign array;  ///< As run: calibrated, where a calibration is named.
  std::string calibrationName;   ///< Fitted numbers of the array; empty without.
  /// "standard": the stylet stays in until full depth; "aos": advance off stylet, the stylet is
  /// held still from the array's hold depth on and the array pushed off it.
  std::string technique = "standard";
  mechanics::ModelKind model = mechanics::ModelKind::rod;  ///< "rod" or "points".
  int nodes = 100;  ///< By default 12 where the model is of points, as published.
  Duration timeStep = milliseconds(1);
  long seed = 1;
  Speed speed = millimetersPerSecond(2);
  Length startInside = millimeters(2);
  Length stopTravel = millimeters(16.5);
  bool withdraws = false;  ///< Pulls the array out again after the stop depth.
  Speed styletSpeed = millimetersPerSecond(5);
  Length leadIn = millimeters(1);
  Angle approachTilt, approachTurn;
  mechanics::FrictionLaw friction;
  mechanics::WallLaw wall;
  /// "none": nothing but the wall; "round-window"; "cochleostomy".
  std::string openingName = "none";
  std::optional<mechanics::Opening> opening;
  /// "rigid": as hard as the bone around it; "soft": yields.
  std::string membraneName = "rigid";
  std::optional<mechanics::MembraneLaw> membrane;
  haptics::EngineSettings engine;  ///< Coupling, force scale.
  std::string
      arrayFingerprint;  ///< Fingerprint of the array's file as read, 16 hexadecimal digits.
  /// The same when this text was written (`array_fingerprint`); empty in people's files.
  std::string expectedArrayFingerprint;
  /// Every key as run and its value as TOML writes it (which JSON reads, too), in their order;
  /// the patient's are called "patient_numbers.st_length_mm" and so on.
  std::vector<std::pair<std::string, std::string>> values;
  /// Every file it was read from: its own, its patient's, array's, friction's and calibration's.
  std::vector<std::filesystem::path> files;
  std::vector<std::string> notes;  ///< What whoever runs it should know, in sentences.
  std::string text;                ///< The scenario as run, TOML: what a recording keeps.
};

/// Values that replace a scenario's own: `--set key=value`, `--patient`, `--array`, `--nodes`.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Reads a scenario by a shipped name or a file's path, with everything it names. A patient is
/// looked for beside the scenario's file, then among the shipped ones; one given as an override is
/// looked for in the working folder first.
Result<Scenario> loadScenario(const std::string& nameOrFile, const Overrides& overrides = {});
/// The same from a text, such as the one a recording keeps. `name` stands for the file in messages.
Result<Scenario> parseScenario(const std::string& text, const std::string& name,
                               const Overrides& overrides = {});

/// The cochlea of a scenario. Takes some tenths of a second.
Result<std::shared_ptr<const anatomy::ScalaTympani>> buildAnatomy(const Scenario& scenario);

/// The model of a scenario. Takes milliseconds.
Result<std::shared_ptr<const mechanics::InsertionModel>> buildModel(
    const Scenario& scenario, std::shared_ptr<const anatomy::ScalaTympani> anatomy);

}  // namespace perilymph::session
