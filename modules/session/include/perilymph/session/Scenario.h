// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The definition of an insertion, from a TOML file.

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

/// A scenario: its TOML file has keys of the same names, with units.
///
/// `text` contains every value as run, with the patient's numbers and the fingerprint of the
/// array's file, so that parseScenario(text) gives the same model anywhere, bit for bit.
struct Scenario {
  std::string name;
  std::string title;  ///< One line for display.
  /// By default the one that the patient's numbers define.
  anatomy::AnatomySource anatomy = anatomy::AnatomySource::published;
  anatomy::Patient patient;  ///< From `patient` (a file or a shipped name), else published.
  std::string patientName;   ///< Value of the key `patient`; empty without one.
  std::string arrayName = "contour";
  electrode::ArrayDesign array;  ///< As run: calibrated, if a calibration is named.
  std::string calibrationName;   ///< Name of the array's calibration; empty without one.
  /// "standard": the stylet stays in until full depth; "aos" (advance off stylet): from the array's
  /// hold depth on the stylet is held and the array is pushed off it.
  std::string technique = "standard";
  mechanics::ModelKind model = mechanics::ModelKind::rod;  ///< "rod" or "points".
  int nodes = 100;  ///< Default 12 for a point set, as published.
  Duration timeStep = milliseconds(1);
  long seed = 1;
  Speed speed = millimetersPerSecond(2);
  Length startInside = millimeters(2);
  Length stopTravel = millimeters(16.5);
  bool withdraws = false;  ///< Withdraws the array after the stop travel.
  Speed styletSpeed = millimetersPerSecond(5);
  Length leadIn = millimeters(1);
  Angle approachTilt, approachTurn;
  mechanics::FrictionLaw friction;
  mechanics::WallLaw wall;
  /// "none": no rim; "round-window"; "cochleostomy".
  std::string openingName = "none";
  std::optional<mechanics::Opening> opening;
  /// "rigid": as stiff as the bone around it; "soft": compliant.
  std::string membraneName = "rigid";
  std::optional<mechanics::MembraneLaw> membrane;
  haptics::EngineSettings engine;  ///< Coupling, force scale.
  std::string arrayFingerprint;    ///< Fingerprint of the array's file, 16 hexadecimal digits.
  /// The same when this text was written (`array_fingerprint`); empty in files of users.
  std::string expectedArrayFingerprint;
  /// Every key as run and its value in TOML format (also valid JSON), in order; those of the
  /// patient are called "patient_numbers.st_length_mm" and so on.
  std::vector<std::pair<std::string, std::string>> values;
  /// All files it was read from: scenario, patient, array, friction and calibration.
  std::vector<std::filesystem::path> files;
  std::vector<std::string> notes;  ///< Messages for the user.
  std::string text;                ///< The scenario as run, TOML, as stored in a recording.
};

/// Values that replace a scenario's own: `--set key=value`, `--patient`, `--array`, `--nodes`.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Reads a scenario by a shipped name or a path, with everything it names. A patient is searched
/// beside the scenario's file, then among the shipped ones; one given as an override is searched in
/// the working folder first.
Result<Scenario> loadScenario(const std::string& nameOrFile, const Overrides& overrides = {});
/// The same from a text, such as that of a recording. Messages show `name` in place of the file.
Result<Scenario> parseScenario(const std::string& text, const std::string& name,
                               const Overrides& overrides = {});

/// Builds the cochlea of a scenario. Takes some tenths of a second.
Result<std::shared_ptr<const anatomy::ScalaTympani>> buildAnatomy(const Scenario& scenario);

/// Builds the model of a scenario. Takes milliseconds.
Result<std::shared_ptr<const mechanics::InsertionModel>> buildModel(
    const Scenario& scenario, std::shared_ptr<const anatomy::ScalaTympani> anatomy);

}  // namespace perilymph::session
