// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The constant data of an insertion.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/mechanics/FrictionLaw.h"
#include "perilymph/mechanics/Membrane.h"
#include "perilymph/mechanics/Opening.h"
#include "perilymph/mechanics/Partition.h"
#include "perilymph/mechanics/PassageModel.h"
#include "perilymph/mechanics/PointSet.h"
#include "perilymph/mechanics/RelaxationLaw.h"
#include "perilymph/mechanics/SolverParameters.h"

namespace perilymph::mechanics {

/// Maximum number of nodes of a model; snapshots and recordings are sized for it.
inline constexpr int maxNodes = 1024;

/// Time over which a precurved array, straight at the start, takes on its rest shape (choice, low).
inline constexpr double releaseTime = 0.2;  // [s]

/// Compliance of the wall; by default as published (Todd and Naghdy, section II.D).
///
/// The force F at a penetration p rises over the thickness t of a soft lining, then with the
/// stiffness k of what supports it; it is continuous with its slope, and its energy E is exact:
///
///     p < t:   F = k p^2 / (2 t)      E = k p^3 / (6 t)
///     p >= t:  F = k (p - t / 2)      E = k (p (p - t) / 2 + t^2 / 6)
struct WallLaw {
  /// Stiffness k of the wall under one sample point of the published simulator [N/m].
  Stiffness perSamplePoint = newtonsPerMeter(441.0);
  /// The same along the wall [N/m].
  Stiffness tangentialPerSamplePoint = newtonsPerMeter(200.0);
  /// Thickness t of the lining; the published wall has none, and t makes its onset smooth.
  Length lining = millimeters(0.01);
  /// Stiffness of the opening's rim under one sample point; as that of the wall if empty [N/m].
  std::optional<Stiffness> rim = std::nullopt;
  /// Time in which the reach of an oval section follows the direction of the wall. With it, the
  /// reach in a groove is the mean over both its walls; 0: at once, and of the nearer wall, so that an
  /// oval array rattles there by millinewtons. 5 to 100 ms give the same forces within 1 % (choice,
  /// low).
  Duration sectionDelay = milliseconds(5.0);
  /// Depth behind the opening over which the wall gets as stiff as it is, as the square of the depth;
  /// 0: over one node spacing, linearly, so that each node that passes the opening is pushed aside in
  /// its own way.
  Length edge = millimeters(0.0);

  Stiffness rimStiffness() const { return rim.value_or(perSamplePoint); }
  /// Penetration over which the forces of rim and membrane set in, which no lining covers.
  Length bareOnset() const { return std::min(lining, millimeters(0.01)); }
};

/// The wall of a cochlea: bone under a thin soft lining.
///
/// Against bone (20 GPa, Turner et al. 1999 in doi 10.3389/fnins.2023.1064890, table 3) the
/// silicone of the carrier and the lining yield: 2,000 to 7,000 N/m under a sample point at forces
/// of 8 to 100 mN, up to k. Stiffness and thickness are choices (low). The mean modulus of the
/// lining over a contact of 0.13 mm by 1.83 mm, fully compressed, is k t / (2 area) = 3.4 MPa.
/// Along the wall and at the rim it is as published. The edge, a choice (low), is as long as three
/// nodes of a plan lie apart: with it an array in front of the opening buckles at the same angle with
/// 50 to 400 nodes (guide, `clinical.md`); half of it moves that angle by 12 degrees.
constexpr WallLaw boneWall()
{
  WallLaw wall;
  wall.perSamplePoint = newtonsPerMeter(20'000.0);
  wall.lining = millimeters(0.08);
  wall.rim = newtonsPerMeter(441.0);
  wall.edge = millimeters(1.0);
  return wall;
}

/// Kind of the array model.
enum class ModelKind {
  rod,     ///< An elastic rod against the smooth wall.
  points,  ///< The published point set against the haptic surface (PointSet.h).
};

/// The parts that a model is built from.
struct ModelParts {
  std::shared_ptr<const anatomy::Lumen> lumen;
  electrode::ArrayDesign array;
  FrictionLaw friction;
  /// By default nothing relaxes. Needs a rod.
  RelaxationLaw relaxation;
  WallLaw wall;
  /// If empty, the membrane is as stiff as the bone around it, as in the published experiment and
  /// in a lumen without known membrane.
  std::optional<MembraneLaw> membrane;
  /// Force within one contact, normal to the cochlear partition, at which it ruptures; 0: never, as
  /// in the published experiment. Needs a scala tympani and a rod.
  Force partitionStrength = newtons(0);
  /// If empty, the lumen's wall begins at the plane of the entry and there is no rim.
  std::optional<Opening> opening;
  int nodes = 100;                      ///< 8 to maxNodes; for a point set 2 to maxPoints.
  Duration timeStep = milliseconds(1);  ///< 0.1 to 10 ms.
  Length startInside =
      millimeters(2);  ///< Initial depth of the tip past the opening; negative: outside.
  Angle approachTilt = radians(0);  ///< Tilt of the array's axis against E.z, toward E.y.
  Angle approachTurn = radians(0);  ///< Rotation of the array's axis against E.z, toward E.x.
  /// Length in front of the opening along which the array is free between it and the forceps,
  /// which hold it straight behind; if empty, all of the array in front of the opening is free.
  std::optional<Length> freeLength;
  ModelKind kind = ModelKind::rod;
  /// Surface that a point set collides with; not used by a rod.
  std::shared_ptr<const anatomy::Surface> hapticSurface;
  SolverParameters solver;  ///< Used for a rod only.
};

/// A relaxing fraction of a stiffness in one time step.
struct RelaxingStep {
  double fraction = 0.0;
  double ratio = 0.0;  ///< Time step over time constant.
};

/// Number of parts of a joint's bending stiffness that yield: wires, each for itself and as a bundle,
/// and the stylet.
inline constexpr std::size_t yieldingBranches = 3;

/// A part of each joint's bending stiffness that yields.
struct YieldingBranch {
  std::vector<double> stiffness;  ///< EI / h at each node [N.m].
  std::vector<double> moment;     ///< Largest moment [N.m]; above 0.
};

/// A cochlea, an array, material laws and solver settings: immutable, shared between threads.
///
/// Node 0 is held by the tweezers, node n - 1 is the tip. Arrays have one entry per node; in arrays
/// over edges, entry i is the edge between nodes i and i + 1.
struct InsertionModel {
  /// Builds a model. @throws std::invalid_argument with a message for parts out of range.
  static std::shared_ptr<const InsertionModel> build(ModelParts parts);

  /// Builds what steps read only in some insertions, and would build themselves when they first need
  /// it: before it, a step is not real-time safe. Any thread, any number of times.
  void prepareForRealTime() const
  {
    if (partition) partition->prepare();
  }

  ModelParts parts;
  anatomy::Entry entry;             ///< The opening, from the lumen.
  Eigen::Vector3d openingCenter_W;  ///< [m]
  Eigen::Vector3d startBase_W;      ///< Initial position of the tweezers [m].
  Eigen::Vector3d startAxis_W;      ///< Unit: direction in which the array leaves them.
  Eigen::Vector3d startCurl_W;      ///< Unit, perpendicular to the axis: direction of curl.
  int nodes = 0;
  double timeStep = 0.0;               ///< [s]
  double spacing = 0.0;                ///< Between nodes [m].
  std::vector<double> fromTip;         ///< Distance of each node from the tip along the array [m].
  std::vector<double> radius;          ///< Radius of the array at each node, the larger one [m].
  std::vector<double> mass;            ///< Mass of each node [kg].
  std::vector<double> drag;            ///< Drag of the perilymph on each node [N.s/m].
  std::vector<double> stretching;      ///< EA of each edge [N].
  std::vector<double> bendingCarrier;  ///< EI of the carrier at each node, the smaller one [N.m^2].
  std::vector<double> bendingExcess;   ///< Amount by which the larger EI exceeds it [N.m^2].
  std::vector<unsigned char> stifferAcross;  ///< Whether the larger EI is across the plane of curl.
  std::vector<double> twisting;              ///< GJ at each node [N.m^2].
  std::vector<double> halfWithin;            ///< Half of the section within the plane of curl [m].
  std::vector<double> halfAcross;            ///< Half of the section across the plane of curl [m].
  bool isOval = false;                       ///< Sections or their stiffness are not round.
  bool twists = false;  ///< Precurved, oval, relaxing or yielding: its rotation about
                        ///< its axis matters.
  /// Maxwell elements of the bending stiffness, and the friction film.
  std::array<RelaxingStep, RelaxationLaw::maxTerms> relaxing;
  RelaxingStep film;
  /// Wires, each for itself and as a bundle, whose moment is limited; empty if nothing yields.
  std::array<YieldingBranch, 2> wires;
  double styletMoment = 0.0;           ///< Moment at which the stylet yields [N.m]; 0: it does not.
  std::vector<double> restCurvature;   ///< Rest curvature of the carrier alone at each node [1/m].
  std::vector<double> wallStiffness;   ///< At each node [N/m].
  std::vector<double> wallTangential;  ///< At each node [N/m].
  std::optional<MembranePlace> membrane;  ///< Region where the wall is soft.
  /// Radius of the largest circle in the lumen behind the opening [m]; infinite where no part of the
  /// array is thicker.
  double mouthRadius = 0.0;
  PartitionRange partitionRange;                    ///< Where the roof is the cochlear partition.
  std::shared_ptr<const PartitionModel> partition;  ///< If it can rupture; else null.
  std::optional<PassageModel> passage;              ///< Passage of the opening, if it has a length.
  double styletBending = 0.0;                       ///< EI of the stylet [N.m^2]; 0 without one.
  double styletFromTip = 0.0;   ///< Distance of its tip from the array's when fully in [m].
  double styletResidual = 0.0;  ///< Fraction of the rest curvature that remains along it.
  double baseMass = 0.0;        ///< Mass of carrier and tweezers [kg].
  /// Constant data of a point set; null for a rod. Shared by copies of the model because of its
  /// size.
  std::shared_ptr<const PointSetModel> points;
  /// Fingerprint of all data that affects results, for recordings.
  std::uint64_t fingerprint = 0;
  /// The fingerprint that earlier recordings hold: without the lumen's tables, the electrode
  /// contacts and other data.
  std::uint64_t formerFingerprint = 0;

  /// Whether a recorded fingerprint, of either kind, matches this model.
  bool hasFingerprint(std::uint64_t recorded) const noexcept
  {
    return recorded == fingerprint || recorded == formerFingerprint;
  }
};

}  // namespace perilymph::mechanics
