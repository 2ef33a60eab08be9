// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A uniform straight rod in a test scene, moved by the test.

#include <memory>
#include <optional>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/mechanics/advance.h"

namespace perilymph::test {

/// Parameters of the rod.
struct RodSpec {
  double length = 20e-3;       ///< [m]
  double radius = 0.25e-3;     ///< [m]
  double bending = 1e-6;       ///< EI [N.m^2]
  double restCurvature = 0.0;  ///< [1/m]
  double curledFromTip = 0.0;  ///< Curled length from the tip [m]; 0: the whole rod.
  double bendingAcross = 0.0;  ///< Across the plane of curl [N.m^2]; 0: the same.
  double thickness = 0.0;      ///< Within the plane of curl [m]; 0: round.
  double twisting = 0.0;       ///< GJ [N.m^2]; 0: derived from its sections.
  mechanics::RelaxationLaw relaxation;
  std::optional<electrode::Wires> wires;
  double friction = 0.0;       ///< Coulomb, the same at rest and sliding.
  double wallStiffness = 1e5;  ///< Per sample point [N/m]: hard against everything tested.
  double startInside = 0.0;    ///< [m]
  double timeStep = 1e-3;      ///< [s]
  int nodes = 101;
  std::optional<mechanics::MembraneLaw> membrane;
  double partitionStrength = 0.0;  ///< [N]
  double tilt = 0.0;               ///< Approach tilted upward by this [rad].
  std::optional<mechanics::Opening> opening;
  std::optional<Length> freeLength;
  std::vector<Length> ribsFromTip;
  double ribHeight = 0.0;  ///< [m]
  double ribLength = 0.0;  ///< [m]
};

/// A rod held rigidly at its base.
class TestRod {
public:
  TestRod(std::shared_ptr<const anatomy::Lumen> lumen, const RodSpec& spec);

  /// Moves the base by `motion_W` in equal ticks at `speed` [m/s], then waits for `rest` seconds.
  void move(const Eigen::Vector3d& motion_W, double speed, double rest = 0.0);

  /// One tick without motion of the base.
  void tick();

  /// The tension in the edge above a node [N]; negative under compression.
  double tension(std::size_t edge) const;

  const mechanics::InsertionModel& model() const { return *model_; }
  mechanics::InsertionModel& changeable() { return *model_; }
  mechanics::InsertionState& state() { return *state_; }
  const mechanics::Readings& readings() const { return state_->readings; }
  mechanics::Drive& drive() { return drive_; }

private:
  std::shared_ptr<mechanics::InsertionModel> model_;
  std::unique_ptr<mechanics::InsertionState> state_;
  mechanics::Drive drive_;
};

}  // namespace perilymph::test
