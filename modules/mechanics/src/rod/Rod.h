#pragma once

// The elastic rod: stretching and bending of a chain of nodes, with material damping.

#include <Eigen/Core>
#include <cstddef>

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// Material damping of silicone over its stiffness: stress = E (strain + time x strain rate). An
/// engineering choice that keeps the rod quiet between ticks; confidence low.
inline constexpr double dampingTime = 2e-3;  // [s]

/// The unknown block that a node belongs to: nodes 0 and 1 are the base's.
inline std::size_t blockOf(std::size_t node) noexcept { return node == 0 ? 0 : node - 1; }

/// Whether the rod's geometric stiffness under compression enters the matrix. Exact with it; always
/// positive definite without.
enum class Compression { included, leftOut };

/// Stiffness EI and rest bend of each node for a place of the stylet.
///
/// The stylet adds its own EI where it is, and holds the carrier straight but for a share of its
/// free curvature. `released` is the share of its rest curvature that the array has taken on.
void setStiffness(const InsertionModel& model, double styletWithdrawal, double released,
                  SectionStiffness& section) noexcept;

/// Rest bends h kappa d as vectors: the curl's direction d is carried along the rod from the base
/// without turning about it (an array that does not twist). Also remembers lengths and bends before
/// the step: what damping is measured against.
void setRestShape(const InsertionModel& model, const std::vector<Eigen::Vector3d>& position_W,
                  const Eigen::Vector3d& curl_W, const SectionStiffness& section,
                  RodKinematics& rod) noexcept;

/// The rod's links at these positions, into rod.edge.
void setEdges(const std::vector<Eigen::Vector3d>& position_W, RodKinematics& rod) noexcept;

/// Adds the rod's forces to force_W, and leaves its edges and their tension in `rod`.
void addRodForces(const InsertionModel& model, const std::vector<Eigen::Vector3d>& position_W,
                  double timeStep, const SectionStiffness& section, RodKinematics& rod,
                  std::vector<Eigen::Vector3d>& force_W) noexcept;

/// Adds the rod's stiffness to the matrix, at the edges where addRodForces() has left it.
void addRodStiffness(const InsertionModel& model, Compression compression, double timeStep,
                     const SectionStiffness& section, const RodKinematics& rod,
                     BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics
