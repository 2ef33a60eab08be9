// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From bench to ear: the friction of an array on fresh tissue, from curves of force over depth that one
// kind of array gave in fresh cochleae and in channels of their shape with lubricants. Procedure,
// geometry, nuisances and ranges: resources/guide/friction.md.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::validation {

enum class BenchMedium { soap, healonInAir, salineHealon, saline, perilymph, tissue };

/// Names of the tables in the files.
inline constexpr std::array<Choice<BenchMedium>, 6> benchMedia{{
    {BenchMedium::soap, "soap"},
    {BenchMedium::healonInAir, "healon-in-air"},
    {BenchMedium::salineHealon, "saline-healon"},
    {BenchMedium::saline, "saline"},
    {BenchMedium::perilymph, "perilymph"},
    {BenchMedium::tissue, "tissue"},
}};

struct BenchCurve {
  BenchMedium medium = BenchMedium::soap;
  std::vector<double> depths;  ///< [m], increasing.
  std::vector<double> forces;  ///< [N], above 0.
};

/// A cochlea and the channel of its shape.
struct BenchSpecimen {
  std::string name;
  bool isPoor = false;  ///< The authors call the agreement of cochlea and channel poor.
  std::vector<BenchCurve> curves;
};

/// The specimens in a folder, sorted by file name. One of them, the first to be returned, has a curve
/// with soap; all have one in tissue and one with saline.
Result<std::vector<BenchSpecimen>> loadBench(const std::filesystem::path& folder);

/// A posterior: median and central 95 %.
struct Estimate {
  double median = 0.0, low = 0.0, high = 0.0;
};

struct MediumFriction {
  std::string specimen;
  BenchMedium medium = BenchMedium::soap;
  Estimate friction;
  std::vector<double> density;  ///< Over ln friction, at BenchResult::frictions.
};

/// Friction of fresh tissue over several specimens: ln mu ~ N(ln median, between^2).
struct TissueFriction {
  std::string specimens;
  Estimate median;       ///< The distribution's.
  Estimate further;      ///< One more specimen's.
  double between = 0.0;  ///< Standard deviation of ln mu between specimens, posterior mean.
};

/// A force behind the depths that were fitted.
struct PredictedForce {
  std::string specimen;
  BenchMedium medium = BenchMedium::soap;
  double depth = 0.0, measured = 0.0;          ///< [m], [N]
  double median = 0.0, low = 0.0, high = 0.0;  ///< Central 90 % [N].
  bool isInside() const noexcept { return measured >= low && measured <= high; }
};

/// ln p of all forces of a specimen behind the depths that were fitted.
struct ModelScore {
  std::string specimen;
  std::size_t forces = 0;
  double capstan = 0.0;        ///< Each medium has a friction of its own.
  double constantRatio = 0.0;  ///< Each medium has the shape of the soap curve, and a factor.
};

struct BenchResult {
  std::vector<double> frictions;      ///< Grid of the posteriors, even in ln friction.
  std::vector<MediumFriction> media;  ///< The first specimen's, all curves together.
  std::vector<MediumFriction> pairs;  ///< Each further one's, with the first one's array.
  std::vector<TissueFriction> tissue;
  std::vector<PredictedForce> predicted;
  std::vector<ModelScore> scores;
  double tipStiffness = 0.0;  ///< EI at the tip [N m^2], at the most likely point of the grid.
  double growth = 0.0;        ///< r of EI(u) = EI(0) (1 + r u / 15 mm), there.
};

/// The whole chain. Depths of 8 to 14 mm are fitted, and 8 to 13 mm for the predictions.
BenchResult inferFriction(const std::vector<BenchSpecimen>& specimens);

}  // namespace perilymph::validation
