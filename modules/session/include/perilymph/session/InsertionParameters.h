// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Parameters of one insertion: cochlea, model, engine and motion.

#include <optional>
#include <string>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/session/ScenarioChoices.h"

namespace perilymph::session {

/// How uncertain a friction is: standard deviations of the logarithm of all its coefficients, for those
/// who draw it. An insertion itself has the friction's own values.
struct FrictionSpread {
  double shared = 0.0;  ///< What is common to all ears.
  double ear = 0.0;     ///< Between ears.

  bool isKnown() const noexcept { return shared > 0.0 || ear > 0.0; }
};

/// Parameters of an insertion. A Scenario contains them together with their text; a study of random
/// insertions varies a copy, which has no text and is not recorded.
struct InsertionParameters {
  std::string name;  ///< Name of the scenario they come from.
  anatomy::Cochlea cochlea;
  electrode::ArrayDesign array;  ///< As run: calibrated, if a calibration is named.
  Technique technique = Technique::standard;
  mechanics::ModelKind model = mechanics::ModelKind::rod;
  int nodes = 100;  ///< Default 12 for a point set, as published.
  Duration timeStep = milliseconds(1);
  long seed = 1;
  Speed speed = millimetersPerSecond(2);
  Length startInside = millimeters(2);
  Length stopTravel = millimeters(16.5);
  bool withdraws = false;  ///< Withdraws the array after the stop travel.
  Speed styletSpeed = millimetersPerSecond(5);
  Angle approachTilt, approachTurn;
  std::optional<Length> freeLength;  ///< Between opening and forceps; empty: the whole array.
  mechanics::FrictionLaw friction;
  FrictionSpread frictionSpread;
  mechanics::RelaxationLaw relaxation;  ///< By default nothing relaxes.
  mechanics::WallLaw wall;
  OpeningKind openingKind = OpeningKind::none;
  std::optional<mechanics::Opening> opening;
  MembraneKind membraneKind = MembraneKind::rigid;
  std::optional<mechanics::MembraneLaw> membrane;
  Force partitionStrength = newtons(0);  ///< Strength of the partition; 0: never ruptures.
  haptics::EngineSettings engine;        ///< Coupling, force scale.
};

/// Travel from a start inside the opening to the array's full depth, in whole micrometers as a
/// scenario writes it; 0 or less if the array starts there or deeper.
Length fullTravel(const electrode::ArrayDesign& array, Length startInside);

/// Value of `stop_travel_mm` that every array allows, for a scenario that is read before the array's
/// full travel is known and replaces it.
inline constexpr const char* anyStopTravel = "0.1";

}  // namespace perilymph::session
