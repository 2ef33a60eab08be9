// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The variable data of an insertion.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/RimContact.h"

namespace perilymph::mechanics {

/// Coupling of the hand to the base of the array.
enum class Coupling : std::uint32_t {
  rigid,   ///< The base follows the hand exactly: scripts, published runs.
  spring,  ///< A spring-damper between them: haptic devices.
};

/// Input of one step.
struct Drive {
  Eigen::Vector3d handPosition_W = Eigen::Vector3d::Zero();  ///< Position of the base commanded by
                                                             ///< the hand [m].
  Eigen::Vector3d handVelocity_W = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d handAxis_W = Eigen::Vector3d::UnitZ();     ///< Unit: direction in which the array
                                                             ///< leaves the hand.
  Eigen::Vector3d handCurl_W = Eigen::Vector3d::UnitX();     ///< Unit, perpendicular to the axis:
                                                             ///< direction of curl.
  double styletWithdrawal = 0.0;                             ///< [m]; 0: fully inserted.
  Coupling coupling = Coupling::rigid;
  double couplingStiffness = 0.0;  ///< [N/m]
  double couplingDamping = 0.0;    ///< [N.s/m]
};

/// Output of one step.
struct Readings {
  double depth = 0.0;         ///< Array length past the plane of the opening [m].
  double angularDepth = 0.0;  ///< Angle of the tip from the round window [rad]; 0 before it.
  double speed = 0.0;         ///< Speed of the base into the cochlea [m/s].
  Eigen::Vector3d handForce_W = Eigen::Vector3d::Zero();   ///< Force of the array on the hand [N].
  Eigen::Vector3d handTorque_W = Eigen::Vector3d::Zero();  ///< About the base [N.m].
  double axialForce = 0.0;      ///< handForce along E.z: positive while pushing in [N].
  double wallForceMax = 0.0;    ///< Maximum normal force on one node [N].
  double wallForceTotal = 0.0;  ///< Sum of all normal forces [N].
  double membraneForce = 0.0;   ///< Sum of the normal forces on the basilar membrane [N].
  /// The largest force on the cochlear partition, bone and membrane, within one width of the array: the
  /// force that ruptures it [N]. That of the last step that was balanced.
  double partitionForce = 0.0;
  double rimForce = 0.0;     ///< Normal force of the opening's rim on the array [N].
  double plasticWork = 0.0;  ///< Work that wires took by yielding, since the start [J].
  int contacts = 0;          ///< Number of nodes that touch the wall.
  int iterations = 0;        ///< Newton iterations in this step.
  int evaluations = 0;       ///< Evaluations of all forces in this step.
  int factorizations = 0;    ///< Factorizations of the stiffness in this step.
  double residual = 0.0;     ///< Maximum unbalanced force on a node [N].
  bool isFinite = true;      ///< False: a value overflowed; all others are unreliable.
};

/// Torque of the wall on an oval section at a node, which turns its thin side toward the wall.
struct WallTorque {
  double torque = 0.0;     ///< About the edge before the node [N.m].
  double stiffness = 0.0;  ///< Upper bound of its derivative by the rotation [N.m].
};

/// Extent of an oval section toward the wall, evaluated where it first comes near it in a step.
struct SectionReach {
  bool isKnown = false;
  double length = 0.0;  ///< [m]
  double rate = 0.0;    ///< Derivative by the rotation of the section [m].
};

/// A bend of each node in components along the node's axes: what one of its Maxwell elements has taken
/// on, or its wires by yielding.
struct MaterialBend {
  std::vector<double> along;   ///< Toward the curl.
  std::vector<double> across;  ///< Perpendicular to it.
};

struct StepWorkspace;

/// Owns the solver's memory: intermediate results of a step, and the last factorization of the
/// stiffness, which is part of the state's value. Copies have their own memory; assignment between
/// states of one model does not allocate.
class WorkspaceHandle {
public:
  /// @param rodNodes  0 for a point set.
  explicit WorkspaceHandle(std::size_t rodNodes);
  WorkspaceHandle(const WorkspaceHandle& other);
  WorkspaceHandle(WorkspaceHandle&& other) noexcept;
  WorkspaceHandle& operator=(const WorkspaceHandle& other);
  WorkspaceHandle& operator=(WorkspaceHandle&& other) noexcept;
  ~WorkspaceHandle();

  StepWorkspace& operator*() noexcept { return *workspace_; }
  const StepWorkspace& operator*() const noexcept { return *workspace_; }
  StepWorkspace* operator->() noexcept { return workspace_.get(); }
  const StepWorkspace* operator->() const noexcept { return workspace_.get(); }

private:
  std::unique_ptr<StepWorkspace> workspace_;  ///< Null only in a moved-from handle.
};

/// The state of an insertion, sized once from the model. Copies compare equal and hash equal.
struct InsertionState {
  /// Initial state: the array straight and at rest.
  explicit InsertionState(const InsertionModel& model);

  /// Restores the initial state without allocating. Real-time safe.
  void reset(const InsertionModel& model) noexcept;

  /// A fingerprint of all data that the next step depends on.
  std::uint64_t fingerprint() const noexcept;

  std::uint64_t tick = 0;
  bool isSettling = false;         ///< The last step was not balanced: the next one continues it.
  Eigen::Vector3d base_W;          ///< Position of the tweezers [m].
  Eigen::Vector3d baseVelocity_W;  ///< [m/s]
  double styletWithdrawal = 0.0;   ///< [m]
  std::vector<Eigen::Vector3d> position_W;  ///< Position of each node [m].
  std::vector<Eigen::Vector3d> velocity_W;  ///< Velocity of each node [m/s].
  /// Smoothed change of its velocity from step to step [m/s], by which a step predicts its end.
  std::vector<Eigen::Vector3d> velocityTrend_W;
  /// Unit direction of curl of each edge (the last one twice).
  std::vector<Eigen::Vector3d> curl_W;
  /// Bends that each Maxwell element has taken on; empty if bends do not relax.
  std::array<MaterialBend, RelaxationLaw::maxTerms> relaxedBend;
  /// Bends that remain of wires and stylet that yielded, of each branch; empty if none can. The stylet's
  /// moves along the array with it.
  std::array<MaterialBend, yieldingBranches> plasticBend;
  std::vector<Eigen::Vector3d>
      frictionFilm_W;  ///< Stretch of each node's relaxing friction film [m];
                       ///< empty without one.
  std::vector<Eigen::Vector3d> frictionSpring_W;  ///< Stretch of each node's friction spring [m].
  std::vector<unsigned char> isSliding;           ///< Whether each node slides.
  std::vector<double> slipSpeed;                  ///< Speed of each node along the wall [m/s].
  std::vector<anatomy::LumenTrack> track;         ///< The turn of the duct each node is in.
  /// Whether each node is over bone beside the opening or in contact with it from outside.
  std::vector<unsigned char> isBeside;
  std::vector<double> clearance;              ///< Distance each node can move in any direction
                                              ///< without touching [m].
  std::vector<double> normalForce;            ///< Normal force of the wall on each node [N].
  std::vector<double> normalForceBefore;      ///< The same at the end of the step before [N].
  std::vector<Eigen::Vector3d> wallForce_W;   ///< Normal and friction on each node [N].
  std::vector<Eigen::Vector3d> wallNormal_W;  ///< Unit normal of the wall at each node that touches
                                              ///< it.
  std::vector<WallTorque> wallTorque;         ///< On each node's section, if oval.
  /// Reach of each oval section in the last step, while it is near a wall with a delay.
  std::vector<SectionReach> section;
  std::vector<double> membraneForce;  ///< Force of the basilar membrane on each node [N].
  RimContact rim;
  double rimForceBefore = 0.0;  ///< Its normal force at the end of the step before [N].
  PartitionState partition;
  PointSetState points;  ///< State of a point set; empty for a rod.
  Readings readings;

  WorkspaceHandle workspace;  ///< Memory of the solver.
};

}  // namespace perilymph::mechanics
