#pragma once

// Everything about one insertion that does not change while it runs.

#include <Eigen/Core>
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
#include "perilymph/mechanics/PointSet.h"

namespace perilymph::mechanics {

/// Most nodes a model may have: what snapshots and recordings are sized for.
inline constexpr int maxNodes = 1024;

/// Over this time a curled array, which starts straight, takes on its rest shape (choice, low).
inline constexpr double releaseTime = 0.2;  // [s]

/// The wall's compliance.
struct WallLaw {
  /// Stiffness of the wall under one sample point of the published simulator [N/m].
  Stiffness perSamplePoint = newtonsPerMeter(441.0);
  /// The same along the wall [N/m].
  Stiffness tangentialPerSamplePoint = newtonsPerMeter(200.0);
  /// The wall's force sets in smoothly over this depth.
  Length onset = millimeters(0.01);
};

/// Which model of the array moves.
enum class ModelKind {
  rod,     ///< An elastic rod against the smooth wall.
  points,  ///< The published point set against the haptic surface (PointSet.h).
};

/// What a model is built from.
struct ModelParts {
  std::shared_ptr<const anatomy::Lumen> lumen;
  electrode::ArrayDesign array;
  FrictionLaw friction;
  WallLaw wall;
  /// Without one the membrane is as hard as the bone around it, as in the published experiment; so
  /// it is in a lumen of which nobody knows where the membrane is.
  std::optional<MembraneLaw> membrane;
  /// Without one the lumen's wall begins at the plane of the entry, and nothing holds the ribs.
  std::optional<Opening> opening;
  int nodes = 100;                      ///< 8 to maxNodes; of points 2 to maxPoints.
  Duration timeStep = milliseconds(1);  ///< 0.1 to 10 ms.
  Length startInside =
      millimeters(2);  ///< Depth of the tip past the opening at the start; negative: outside.
  Angle approachTilt = radians(0);  ///< Tilt of the array's axis against E.z, toward E.y.
  Angle approachTurn = radians(0);  ///< The same, toward E.x.
  ModelKind kind = ModelKind::rod;
  /// What points touch; a rod does not need it.
  std::shared_ptr<const anatomy::Surface> hapticSurface;
};

/// A cochlea, an array, material laws and solver settings: immutable, shared between threads.
///
/// Node 0 is held by the tweezers, node n - 1 is the tip. Arrays run over nodes; those over edges
/// have their edge i between nodes i and i + 1.
struct InsertionModel {
  /// Builds a model. @throws std::invalid_argument with a sentence for parts out of range.
  static std::shared_ptr<const InsertionModel> build(ModelParts parts);

  ModelParts parts;
  anatomy::Entry entry;             ///< The opening, from the lumen.
  Eigen::Vector3d openingCenter_W;  ///< [m]
  Eigen::Vector3d startBase_W;      ///< Where the tweezers start [m].
  Eigen::Vector3d startAxis_W;      ///< Unit: which way the array leaves them.
  Eigen::Vector3d startCurl_W;      ///< Unit, across the axis: to where a precurved array curls.
  int nodes = 0;
  double timeStep = 0.0;               ///< [s]
  double spacing = 0.0;                ///< Between nodes [m].
  std::vector<double> fromTip;         ///< Distance of each node from the tip along the array [m].
  std::vector<double> radius;          ///< Radius of the array at each node, the greater [m].
  std::vector<double> mass;            ///< Mass of each node [kg].
  std::vector<double> drag;            ///< Drag of the perilymph on each node [N.s/m].
  std::vector<double> stretching;      ///< EA of each edge [N].
  std::vector<double> bendingCarrier;  ///< EI of the carrier at each node, the lesser [N.m^2].
  std::vector<double> bendingExcess;   ///< By which the greater EI exceeds it [N.m^2].
  std::vector<unsigned char> stifferAcross;  ///< Whether that is across the plane of curl.
  std::vector<double> twisting;              ///< GJ at each node [N.m^2].
  std::vector<double> halfWithin;            ///< Half an oval section, toward the curl [m].
  std::vector<double> halfAcross;            ///< Half an oval section, across it [m].
  bool isOval = false;                       ///< Sections, or their stiffness, are not round.
  bool twists = false;                       ///< Curled or oval: turning it about its axis counts.
  std::vector<double> restCurvature;   ///< Rest curvature of the carrier alone at each node [1/m].
  std::vector<double> wallStiffness;   ///< At each node [N/m].
  std::vector<double> wallTangential;  ///< At each node [N/m].
  std::optional<MembranePlace> membrane;  ///< Where the wall is soft.
  double styletBending = 0.0;             ///< EI of the stylet [N.m^2]; 0 without one.
  double styletFromTip = 0.0;   ///< Distance of its tip from the array's when fully in [m].
  double styletResidual = 0.0;  ///< Share of the rest curvature that it leaves where it is.
  double baseMass = 0.0;        ///< Mass of carrier and tweezers [kg].
  /// The model of points; empty for a rod. Copies of the model share it, for it is large.
  std::shared_ptr<const PointSetModel> points;
  std::uint64_t fingerprint = 0;  ///< Fingerprint of everything above, for recordings.
};

}  // namespace perilymph::mechanics
