// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorBars.h"

#include <algorithm>
#include <cmath>

#include "Pieces.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

// Standard deviation due to the limits of the fitted shape [mm]: a constant, and a part
// proportional to the geometric mean of the voxel size. Calibrated on phantoms (the module's README
// has the coverage).
struct ModelError {
  double constant, perVoxel;
};
constexpr ModelError modelOfA{0.06, 0.08}, modelOfB{0.045, 0.08}, modelOfH{0.10, 0.22};

constexpr double hFirst_deg = 20.0;  // below this angle the vestibule opens into the lumen

Length diameter(double mm) { return millimeters(std::max(2.0, mm)); }

/// Length of the duct along the organ of Corti [mm]; A and B are at least 2 mm.
double organOfCorti(double a_mm, double b_mm)
{
  return inMillimeters(anatomy::ellipticCircularDuctLength(diameter(a_mm), diameter(b_mm)));
}

struct Values {
  double a, b, h;
};

Values valuesOf(const LumenShape& family, const ShapeVector& shape, const RoundWindow& window,
                const Eigen::Vector3d& axis_W, double turn)
{
  const ShapedLumen lumen(family, shape);
  const LumenWall wall = wallOf(lumen, degrees(hFirst_deg).si());
  // The window follows the outer wall when it moves along it or the wall changes.
  const double angle = window.angle + turn;
  const SineCosine direction = sineCosine(angle);
  const Eigen::Vector3d& center = window.center_W;
  const double radius = std::sqrt(center.x() * center.x() + center.y() * center.y()) +
                        lumen.place(angle).outer - lumen.place(window.angle).outer;
  const Eigen::Vector3d moved(radius * direction.cosine, radius * direction.sine, center.z());
  const WallMeasures measured = measureWall(wall, clinicalFrame(axis_W, moved), moved);
  return {measured.a, measured.b, measured.h};
}

}  // namespace

void fillMeasures(const LumenShape& family, const FitResult& fit, const RoundWindow& window,
                  const Eigen::Vector3d& axis_W, const Eigen::Vector3d& spacing_mm,
                  CochleaMeasures& measures)
{
  const ShapeVector& shape = fit.state.shape;
  const Values best = valuesOf(family, shape, window, axis_W, 0.0);

  // Derivatives by every parameter of the shape.
  constexpr double step = 0.02;
  Eigen::Matrix<double, 3, shape::count> slopes;
  eachPiece(shape::count, Threads::all, [&](std::size_t piece) {
    const auto i = static_cast<Eigen::Index>(piece);
    ShapeVector moved = shape;
    moved[i] += step;
    const Values there = valuesOf(family, moved, window, axis_W, 0.0);
    slopes.col(i) << (there.a - best.a) / step, (there.b - best.b) / step,
        (there.h - best.h) / step;
  });
  const Eigen::MatrixXd covariance = fit.covariance.bottomRightCorner(shape::count, shape::count);
  const double blur[3] = {fit.state.blurInPlane, fit.state.blurInPlane, fit.state.blurAxial};
  double correlated = 1.0;
  for (int i = 0; i < 3; ++i)
    correlated *= std::max(1.0, 2.0 * std::sqrt(pi) * blur[i] / spacing_mm[i]);
  // Subsampled voxels are not neighbors.
  correlated = 1.0 + (correlated - 1.0) * fit.sampled;
  const Eigen::Matrix3d propagated = slopes * covariance * slopes.transpose();
  const Eigen::Matrix3d byMarks = slopes *
                                  fit.markCovariance.bottomRightCorner(shape::count, shape::count) *
                                  slopes.transpose();

  const double voxel = power(std::max(1e-9, spacing_mm.prod()), 1.0 / 3.0);
  const Values turned = valuesOf(family, shape, window, axis_W, window.angleError);
  const auto fill = [&](int i, double value, double there, const ModelError& error) {
    Measure measure;
    measure.value = std::round(100.0 * value) / 100.0;  // as it is shown, so that all use the same
    measure.statistical = std::sqrt(std::max(0.0, correlated * propagated(i, i) + byMarks(i, i)));
    measure.model = error.constant + error.perVoxel * voxel;
    measure.definition = std::fabs(there - value);
    return measure;
  };
  measures.a = fill(0, best.a, turned.a, modelOfA);
  measures.b = fill(1, best.b, turned.b, modelOfB);
  measures.h = fill(2, best.h, turned.h, modelOfH);

  // as all pages and files compute it from the measures that are shown; the parts share it by squares
  const Length a = diameter(measures.a.value), b = diameter(measures.b.value);
  const auto errorBy = [&](double ofA, double ofB) {
    return inMillimeters(anatomy::ductLengthError(a, b, {millimeters(ofA), millimeters(ofB)}));
  };
  const Eigen::Vector3d parts(errorBy(measures.a.statistical, measures.b.statistical),
                              errorBy(measures.a.model, measures.b.model),
                              errorBy(measures.a.definition, measures.b.definition));
  const double scale = errorBy(measures.a.sd(), measures.b.sd()) / parts.norm();
  const double ofFormula = inMillimeters(anatomy::ductLengthFormulaError(a, b));
  measures.cdlOc =
      Measure{organOfCorti(measures.a.value, measures.b.value), scale * parts[0], scale * parts[1],
              std::sqrt(scale * scale * parts[2] * parts[2] + ofFormula * ofFormula)};
}

}  // namespace perilymph::ct
