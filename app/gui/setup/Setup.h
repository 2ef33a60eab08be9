#pragma once

// What is about to be inserted into whom, and how one change of it takes along what depends on it.

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// What a person may change. Consecutive changes of one field are undone together.
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
  model,
  nodes,
  forceScale
};

/// Where a number of a patient comes from.
enum class ValueSource { standard, typed, ct };

/// A scenario, and where its patient's numbers come from: those not named are the standard ones.
struct Setup {
  session::Scenario scenario;
  std::map<SetupField, ValueSource> sources;

  ValueSource sourceOf(SetupField field) const
  {
    const auto found = sources.find(field);
    return found == sources.end() ? ValueSource::standard : found->second;
  }
};

/// What a setup began as. A preset claims something (to be the published experiment), so that any
/// change of it is shown; a patient's own scenario claims nothing.
struct SetupOrigin {
  enum class Kind { preset, own };
  Setup setup;
  Kind kind = Kind::preset;
};

/// New values of a scenario's keys, as TOML writes them, for one field.
struct SetupChange {
  SetupField field;
  session::Overrides values;
  QString text;  ///< What it does, for the undo list: "speed 1.0 mm/s".
  ValueSource sources = ValueSource::typed;
};

/// A string as TOML writes it.
std::string tomlQuoted(const QString& text);

/// The setup with a change. What depends on the field follows:
/// - another array drops the fitted numbers and the fingerprint of the one before, goes no deeper
///   than it may, and has no technique that it cannot;
/// - another friction or model drops the coefficients or the nodes of the one before;
/// - another anatomy drops the numbers of the patient before.
/// The scenario's title says what was changed of a preset, so that no recording claims to be one
/// that it is not. Without differences it is the origin again.
Result<Setup> changed(const Setup& now, const SetupOrigin& origin, const SetupChange& change);

/// In which fields two scenarios differ, but for their titles: words, each once and in a fixed
/// order: "array", "speed".
std::vector<std::string> differingText(const session::Scenario& one,
                                       const session::Scenario& other);

/// A file's name from a patient's: letters and digits stay, everything else becomes a dash.
std::string fileNameOf(const std::string& label);

/// The scenario of a patient of one's own: named after the patient and no longer after a preset.
Result<session::Scenario> asOwn(const session::Scenario& scenario);

}  // namespace perilymph::gui
