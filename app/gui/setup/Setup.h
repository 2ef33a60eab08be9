// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The setup of an insertion, and changes with their dependent values.

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// The fields that can be changed. Consecutive changes of one field are undone together.
enum class SetupField {
  preset,
  patientLabel,
  side,
  anatomy,
  scalaLength,
  windowWidth,
  windowHeight,
  lengthA,
  widthB,
  heightH,
  array,
  technique,
  speed,
  stopTravel,
  friction,
  opening,
  approach,
  model,
  nodes,
  forceScale
};

/// Source of a patient's number.
enum class ValueSource { standard, typed, ct };

/// A scenario, and the sources of its patient's numbers; numbers not listed are standard ones.
struct Setup {
  session::Scenario scenario;
  std::map<SetupField, ValueSource> sources;

  ValueSource sourceOf(SetupField field) const
  {
    const auto found = sources.find(field);
    return found == sources.end() ? ValueSource::standard : found->second;
  }
};

/// The initial state of a setup. A preset represents something (such as the published experiment),
/// so that any change of it is marked; a patient's own scenario is not.
struct SetupOrigin {
  enum class Kind { preset, own };
  Setup setup;
  Kind kind = Kind::preset;
};

/// New values of a scenario's keys, in TOML format, for one field.
struct SetupChange {
  SetupField field;
  session::Overrides values;
  QString text;  ///< Description for the undo list: "speed 1.0 mm/s".
  ValueSource sources = ValueSource::typed;
};

/// A string in TOML format.
std::string tomlQuoted(const QString& text);

/// The setup with a change. Dependent values follow:
/// - another array removes the calibration and the fingerprint of the previous one, is inserted
///   fully unless a stop travel was chosen, and changes an unsupported technique;
/// - another friction or model removes the coefficients or the nodes of the previous one;
/// - another anatomy removes the numbers of the previous patient.
/// The scenario's title lists the changes of a preset, so that a recording is not mistaken for one
/// of the preset. Without differences the result is the origin.
Result<Setup> changed(const Setup& now, const SetupOrigin& origin, const SetupChange& change);

/// The fields in which two scenarios differ, except their titles: words, each once and in a fixed
/// order: "array", "speed".
std::vector<std::string> differingText(const session::Scenario& one,
                                       const session::Scenario& other);

/// A scenario with the numbers, the ear and the name of a patient, named after the patient.
Result<session::Scenario> withPatient(const session::Scenario& scenario,
                                      const anatomy::Patient& patient);

/// A patient's label in a file's name: letters and digits are kept, all else between them becomes
/// one dash.
std::string fileStemOf(const std::string& label);
/// The same with the ending of a patient file.
std::string fileNameOf(const std::string& label);

/// The change of a setup to an approach, which is given to a hundredth of a degree.
SetupChange approachChange(const anatomy::Approach& approach);
/// A scenario with an approach.
Result<session::Scenario> withApproach(const session::Scenario& scenario,
                                       const anatomy::Approach& approach);

/// The scenario of the user's own patient: named after the patient instead of a preset.
Result<session::Scenario> asOwn(const session::Scenario& scenario);

}  // namespace perilymph::gui
