// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "EarFrame.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::outcome {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double fitReach_mm = 0.9;  // from the points: voxels of the fit
constexpr double plate_mm =
    0.45;  // width of a plate around the carrier (low confidence: plates differ)
constexpr double thin_mm2 =
    0.005;  // square of the width that the bend of a plate gives it across its plane
constexpr double onCarrier =
    0.95;  // a plate's distance from the center line over the carrier's radius
constexpr double wireStep_mm = 0.2,
                 bundle_mm = 0.06;  // radius of the wires' bundle (choice, low confidence)
constexpr double wire_mm = 0.025,
                 plateThickness_mm = 0.035;  // diameter of a wire (arrays' files; low confidence)
constexpr double minWire = 0.3;              // of the signal that a wire should have
constexpr double studentDegrees = 4.0;
constexpr double modelPart = 0.08;  // error of the model as a part of the metal's signal
constexpr double minNoise = 40.0, maxNoise = 250.0;
constexpr double blurSpread = 0.35;  // of the blur about its guess
constexpr double amplitudeSpread = 0.4,
                 mergedSpread = 0.25;           // among contacts, and among those not seen singly
constexpr double leadBend_mm = 0.6;             // bending of the lead from point to point
constexpr double minBlur = 0.3, maxBlur = 1.5;  // of the guess
constexpr double keptOfThinned = 4.0;
constexpr int minRounds = 6;
constexpr double converged = 0.3;    // of the cost, in one round
constexpr double keptSd_mm = 0.002;  // what a person placed stays

/// Normal density of one blur and what its derivatives need.
struct Spot {
  Matrix3d inverse;
  double factor;
  double value(const Vector3d& off) const
  {
    return factor * exponential(-0.5 * off.dot(inverse * off));
  }
};

Spot spotOf(const Matrix3d& covariance)
{
  const double determinant = std::max(1e-9, covariance.determinant());
  return {covariance.inverse(), 1.0 / (std::pow(2.0 * pi, 1.5) * std::sqrt(determinant))};
}

/// Voxels much finer than the blur are redundant: of these every fourth is taken, on a face-centered grid.
bool isThinned(const Vector3d& spacing)
{
  constexpr double fine_mm = 0.17;
  return spacing.maxCoeff() < fine_mm;
}

class Fit {
public:
  Fit(const EarFrame& frame, const ct::CtVolume& volume, const MetalGrid& grid, const Ear& ear,
      const std::vector<FitVoxel>& voxels, const electrode::ArrayDesign& array,
      const FittedChain& start, const RefinementSettings& settings)
      : frame_(frame),
        array_(array),
        voxels_(voxels),
        settings_(settings),
        ceiling_(grid.ceiling),
        count_(array.contactsFromTip.size()),
        nodes_(start.position_P.size()),
        chain_(start)
  {
    spacing_ = volume.spacing_mm();
    Eigen::Index slow = 2;
    for (Eigen::Index i = 0; i < 3; ++i)
      if (spacing_[i] > 1.05 * spacing_[slow]) slow = i;
    normal_ = volume.lpsFromIndex().block<3, 1>(0, slow).normalized();
    guess_ = {start.blurInPlane_mm, start.blurAxial_mm};
    size_ = static_cast<Eigen::Index>(3 * nodes_ + count_ + 5);
    x_ = Eigen::VectorXd::Zero(size_);
    for (std::size_t i = 0; i < nodes_; ++i)
      x_.segment<3>(3 * static_cast<Eigen::Index>(i)) = start.position_P[i];
    x_[blurAt()] = start.blurInPlane_mm;
    x_[blurAt() + 1] = start.blurAxial_mm;
    x_[levelAt()] = ear.measures.lumenLevel < 500.0 && ear.measures.lumenLevel > -300.0
                        ? ear.measures.lumenLevel
                        : 50.0;
    x_[levelAt() + 1] = grid.bone;
    for (std::size_t i = 0; i < count_; ++i)
      wirePart_ += wirePartOf(i) / static_cast<double>(count_);
    startAmplitudes(grid);
    setWires();
  }

  FittedChain run()
  {
    double damping = 1e-2;
    noise_ = 150.0;
    for (int round = 0; round < settings_.rounds; ++round) {
      setChords();
      System system = assemble(x_, true);
      hold(system);
      noise_ = std::clamp(0.5 * noise_ + 0.5 * system.spread, minNoise, maxNoise);
      const double before = assembleCost(x_);
      double gained = 0.0;
      bool isBetter = false;
      for (int attempt = 0; attempt < 6 && !isBetter; ++attempt) {
        Eigen::MatrixXd left = system.left;
        left.diagonal() *= 1.0 + damping;
        left.diagonal().array() += 1e-12;
        const Eigen::VectorXd step = left.ldlt().solve(system.right);
        if (!step.allFinite()) break;
        const Eigen::VectorXd next = bounded(x_ + limited(step));
        if (const double after = assembleCost(next); after < before) {
          gained = before - after;
          x_ = next;
          damping = std::max(1e-6, 0.3 * damping);
          isBetter = true;
        } else {
          damping *= 6.0;
        }
      }
      if (!isBetter || (round >= minRounds && gained < converged)) break;
    }
    return result();
  }

private:
  struct System {
    Eigen::MatrixXd left;
    Eigen::VectorXd right;
    double spread = 0.0;
  };

  Eigen::Index amplitudeAt() const { return static_cast<Eigen::Index>(3 * nodes_); }
  Eigen::Index wireAt() const { return amplitudeAt() + static_cast<Eigen::Index>(count_); }
  Eigen::Index levelAt() const { return wireAt() + 1; }
  Eigen::Index blurAt() const { return levelAt() + 2; }
  Vector3d nodeOf(const Eigen::VectorXd& x, std::size_t i) const
  {
    return x.segment<3>(3 * static_cast<Eigen::Index>(i));
  }

  Matrix3d blurOf(const Eigen::VectorXd& x) const
  {
    const Matrix3d across = normal_ * normal_.transpose();
    return x[blurAt()] * x[blurAt()] * (Matrix3d::Identity() - across) +
           x[blurAt() + 1] * x[blurAt() + 1] * across;
  }

  void startAmplitudes(const MetalGrid& grid)
  {
    const Matrix3d blur = blurOf(x_);
    const double atCenter = spotOf(blur + plate_mm * plate_mm / 12.0 * Matrix3d::Identity()).factor;
    for (std::size_t i = 0; i < count_; ++i) {
      const double metal =
          std::max(300.0, grid.sample(grid.value, chain_.position_P[i]) + aboveContent);
      x_[amplitudeAt() + static_cast<Eigen::Index>(i)] = 0.8 * metal / atCenter;
    }
    x_[wireAt()] = wirePart_ * meanAmplitude(x_);
  }

  double meanAmplitude(const Eigen::VectorXd& x) const
  {
    return x.segment(amplitudeAt(), static_cast<Eigen::Index>(count_)).mean();
  }

  /// Signal of a millimeter of one wire over that of a contact: area over volume of platinum, nearly of one density.
  double wirePartOf(std::size_t contact) const
  {
    const electrode::Section section = array_.sectionAt(array_.contactsFromTip[contact]);
    const double around = 0.5 * pi * inMillimeters(section.within + section.across);
    const electrode::Plates plates = array_.platesOf(contact);
    const double width = plates == electrode::Plates::band   ? around
                         : plates == electrode::Plates::pair ? std::min(2.0 * plate_mm, around)
                                                             : std::min(plate_mm, 0.5 * around);
    return 0.25 * pi * wire_mm * wire_mm /
           (inMillimeters(array_.contactLength) * width * plateThickness_mm);
  }

  /// Pairs and bands have their middle on the center line, single plates beside it.
  double besideCourse(std::size_t contact) const
  {
    return array_.platesOf(contact) == electrode::Plates::single ? 1.0 : 0.0;
  }

  /// Distances that neighbors should have: the array's spacings on the bent course, with the distance of the contacts
  /// from the center line, one for all, that fits best.
  void setChords()
  {
    constexpr double offsetSd = 0.4;
    chord_.assign(count_, 0.0);
    chordSd_.assign(count_, 0.0);
    std::vector<double> whole(count_, 0.0), nearer(count_, 0.0);
    double top = contactOffset / (offsetSd * offsetSd), bottom = 1.0 / (offsetSd * offsetSd);
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      const double arc =
          inMillimeters(array_.contactsFromTip[i + 1]) - inMillimeters(array_.contactsFromTip[i]);
      double bend = 0.0;
      int known = 0;
      for (const std::size_t at : {i, i + 1}) {
        if (at == 0) continue;
        const Vector3d a = nodeOf(x_, at) - nodeOf(x_, at - 1),
                       b = nodeOf(x_, at + 1) - nodeOf(x_, at);
        const double turn = arcTangent(a.cross(b).norm(), a.dot(b));
        bend += 2.0 * turn / std::max(0.1, a.norm() + b.norm());
        ++known;
      }
      bend = std::min(1.0, bend / std::max(1, known));
      const double half = 0.5 * inMillimeters(array_.sectionAt(array_.contactsFromTip[i]).within);
      whole[i] = arc * (1.0 - std::min(0.3, bend * bend * arc * arc / 24.0));
      nearer[i] = whole[i] * bend * half * 0.5 * (besideCourse(i) + besideCourse(i + 1));
      chordSd_[i] = 0.02 + 0.01 * arc + 0.08 * nearer[i];
      const double weight = 1.0 / (chordSd_[i] * chordSd_[i]);
      top += weight * nearer[i] * (whole[i] - (nodeOf(x_, i + 1) - nodeOf(x_, i)).norm());
      bottom += weight * nearer[i] * nearer[i];
    }
    offset_ = std::clamp(top / bottom, 0.0, 1.0);  // within the carrier
    offsetCost_ = (offset_ - contactOffset) * (offset_ - contactOffset) / (offsetSd * offsetSd);
    for (std::size_t i = 0; i + 1 < count_; ++i) chord_[i] = whole[i] - offset_ * nearer[i];
  }

  Eigen::VectorXd limited(const Eigen::VectorXd& step) const
  {
    Eigen::VectorXd result = step;
    for (std::size_t i = 0; i < nodes_; ++i) {
      const double length = step.segment<3>(3 * static_cast<Eigen::Index>(i)).norm();
      if (length > 0.3) result.segment<3>(3 * static_cast<Eigen::Index>(i)) *= 0.3 / length;
    }
    return result;
  }

  /// Takes out what would leave its bounds, so that the step of the rest is the best one without it.
  void hold(System& system) const
  {
    const auto one = [&](Eigen::Index at, bool isHeld) {
      if (!isHeld) return;
      system.left.row(at).setZero();
      system.left.col(at).setZero();
      system.left(at, at) = 1.0;
      system.right[at] = 0.0;
    };
    for (std::size_t i = 0; i < count_; ++i) {
      const Eigen::Index at = amplitudeAt() + static_cast<Eigen::Index>(i);
      one(at, x_[at] <= 0.0 && system.right[at] < 0.0);
    }
    one(wireAt(),
        x_[wireAt()] <= minWire * wirePart_ * meanAmplitude(x_) && system.right[wireAt()] < 0.0);
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Eigen::Index at = blurAt() + i;
      one(at, (x_[at] <= minBlur * guess_[i] && system.right[at] < 0.0) ||
                  (x_[at] >= maxBlur * guess_[i] && system.right[at] > 0.0));
    }
  }

  Eigen::VectorXd bounded(Eigen::VectorXd x) const
  {
    for (std::size_t i = 0; i < count_; ++i) {
      double& amplitude = x[amplitudeAt() + static_cast<Eigen::Index>(i)];
      amplitude = std::max(0.0, amplitude);
    }
    x[wireAt()] = std::max(minWire * wirePart_ * meanAmplitude(x), x[wireAt()]);
    for (Eigen::Index i = 0; i < 2; ++i)
      x[blurAt() + i] = std::clamp(x[blurAt() + i], minBlur * guess_[i], maxBlur * guess_[i]);
    return x;
  }

  /// Model and derivatives at a voxel: indices and values of those that are not zero.
  struct Local {
    explicit Local(Eigen::Index size)
        : values(Eigen::VectorXd::Zero(size)), isKnown(static_cast<std::size_t>(size), 0)
    {
    }
    double model = 0.0, metal = 0.0;
    std::vector<std::pair<Eigen::Index, double>> slope;

    void add(Eigen::Index at, double value)
    {
      if (!isKnown[static_cast<std::size_t>(at)]) known.push_back(at);
      isKnown[static_cast<std::size_t>(at)] = 1;
      values[at] += value;
    }
    /// Moves what was added into `slope`, in the order of the indices.
    void collect()
    {
      slope.clear();
      std::sort(known.begin(), known.end());
      for (const Eigen::Index at : known) {
        slope.emplace_back(at, values[at]);
        values[at] = 0.0;
        isKnown[static_cast<std::size_t>(at)] = 0;
      }
      known.clear();
    }

  private:
    Eigen::VectorXd values;
    std::vector<char> isKnown;
    std::vector<Eigen::Index> known;
  };

  /// A place of the wires on the smooth course through the nodes, which is linear in four of them.
  struct WireSpot {
    std::size_t segment;
    std::array<double, 4> of;  // the nodes from segment - 1 on; 0 where there is none
    double number, length;     // of wires; that it stands for
    Vector3d place = Vector3d::Zero();
  };

  /// A plate of a contact: its center from the contact's, and its part of the contact's signal.
  struct Plate {
    std::size_t contact;
    Vector3d off;
    double part;
    Spot spot;
  };

  struct Prepared {
    std::vector<Plate> plates;
    Spot wire;
    std::vector<WireSpot> wires;
    double cut;  // squared distance beyond which nothing counts
  };

  /// The course is a cubic between neighboring nodes, with the tangent of the parabola through three of them.
  void setWires()
  {
    const auto knot = [&](std::size_t i) {
      return inMillimeters(array_.contactsFromTip[std::min(i, count_ - 1)]) +
             (i < count_ ? 0.0 : leadStep_mm * static_cast<double>(i - count_ + 1));
    };
    for (std::size_t i = 0; i + 1 < nodes_; ++i) {
      const double h = knot(i + 1) - knot(i);
      const int samples = std::max(1, static_cast<int>(std::ceil(h / wireStep_mm)));
      for (int s = 0; s < samples; ++s) {
        const double t = (s + 0.5) / samples;
        WireSpot spot{
            i, {0.0, 0.0, 0.0, 0.0}, static_cast<double>(std::min(i + 1, count_)), h / samples};
        const double ofFirst = t * (1.0 - t) * (1.0 - t), ofSecond = t * t * (t - 1.0);
        spot.of[1] = (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t);
        spot.of[2] = t * t * (3.0 - 2.0 * t);
        // tangents times h
        if (i == 0) {
          spot.of[1] -= ofFirst;
          spot.of[2] += ofFirst;
        } else {
          const double g = knot(i) - knot(i - 1), sum = g + h;
          spot.of[0] -= ofFirst * h * h / (g * sum);
          spot.of[1] += ofFirst * (h * h / (g * sum) - g / sum);
          spot.of[2] += ofFirst * g / sum;
        }
        if (i + 2 == nodes_) {
          spot.of[1] -= ofSecond;
          spot.of[2] += ofSecond;
        } else {
          const double k = knot(i + 2) - knot(i + 1), sum = h + k;
          spot.of[1] -= ofSecond * k / sum;
          spot.of[2] += ofSecond * (k / sum - h * h / (k * sum));
          spot.of[3] += ofSecond * h * h / (k * sum);
        }
        wires_.push_back(spot);
      }
    }
  }

  Prepared prepare(const Eigen::VectorXd& x) const
  {
    Prepared p;
    const Matrix3d blur = blurOf(x);
    const double length = inMillimeters(array_.contactLength);
    const auto square = [](const Vector3d& v) -> Matrix3d { return v * v.transpose(); };
    std::vector<Vector3d> toCenter(nodes_, Vector3d::Zero());  // from a node to the wires
    for (std::size_t i = 0; i < count_; ++i) {
      const Vector3d along = (nodeOf(x, i + 1) - nodeOf(x, i > 0 ? i - 1 : 0)).normalized();
      const Vector3d at_W = frame_.toW(nodeOf(x, i));
      Vector3d inward = frame_.directionToP(Vector3d(-at_W.x(), -at_W.y(), 0.0).normalized());
      inward = (inward - inward.dot(along) * along).normalized();
      const Vector3d up = along.cross(inward);
      const electrode::Section section = array_.sectionAt(array_.contactsFromTip[i]);
      const double half = 0.25 * inMillimeters(section.within + section.across);
      const Matrix3d ofLength = blur + length * length / 12.0 * square(along);
      const double wide = plate_mm * plate_mm / 12.0;
      toCenter[i] = -besideCourse(i) * onCarrier * half * inward;
      switch (array_.platesOf(i)) {
        case electrode::Plates::single:
          p.plates.push_back({i, Vector3d::Zero(), 1.0,
                              spotOf(ofLength + wide * square(up) + thin_mm2 * square(inward))});
          break;
        case electrode::Plates::pair:
          for (const double sign : {-1.0, 1.0})
            p.plates.push_back({i, sign * onCarrier * half * up, 0.5,
                                spotOf(ofLength + wide * square(inward) + thin_mm2 * square(up))});
          break;
        case electrode::Plates::band:
          p.plates.push_back(
              {i, Vector3d::Zero(), 1.0,
               spotOf(ofLength + 0.5 * half * half * (square(up) + square(inward)))});
      }
    }
    p.wire = spotOf(blur + bundle_mm * bundle_mm * Matrix3d::Identity());
    p.wires = wires_;
    for (WireSpot& wire : p.wires)
      for (std::size_t k = 0; k < 4; ++k)
        if (wire.of[k] != 0.0)
          wire.place +=
              wire.of[k] * (nodeOf(x, wire.segment + k - 1) + toCenter[wire.segment + k - 1]);
    const double widest = std::max(x[blurAt()], x[blurAt() + 1]);
    p.cut = std::pow(3.7 * widest + 0.4, 2);
    return p;
  }

  void evaluate(const Eigen::VectorXd& x, const Prepared& p, const FitVoxel& voxel, bool withSlopes,
                Local& local) const
  {
    local.metal = 0.0;
    double byInPlane = 0.0, byAxial = 0.0;
    const auto addBlur = [&](const Spot& spot, const Vector3d& y, double signal) {
      // derivatives of the density by both widths: S' = 2 sigma M, with M the projection
      const double yAxial = y.dot(normal_);
      const double inPlane = y.squaredNorm() - yAxial * yAxial;
      const double traceAxial = normal_.dot(spot.inverse * normal_);
      const double trace = spot.inverse.trace() - traceAxial;
      byInPlane += signal * x[blurAt()] * (inPlane - trace);
      byAxial += signal * x[blurAt() + 1] * (yAxial * yAxial - traceAxial);
    };
    for (const Plate& plate : p.plates) {
      const Vector3d off = voxel.point_P - nodeOf(x, plate.contact) - plate.off;
      if (off.squaredNorm() > p.cut) continue;
      const auto i = static_cast<Eigen::Index>(plate.contact);
      const double density = plate.part * plate.spot.value(off);
      const double amplitude = x[amplitudeAt() + i];
      local.metal += amplitude * density;
      if (!withSlopes) continue;
      const Vector3d y = plate.spot.inverse * off;
      for (Eigen::Index d = 0; d < 3; ++d) local.add(3 * i + d, amplitude * density * y[d]);
      local.add(amplitudeAt() + i, density);
      addBlur(plate.spot, y, amplitude * density);
    }
    double byWire = 0.0;
    for (const WireSpot& wire : p.wires) {
      const Vector3d off = voxel.point_P - wire.place;
      if (off.squaredNorm() > p.cut) continue;
      const double density = p.wire.value(off) * wire.length;
      const double signal = x[wireAt()] * wire.number * density;
      local.metal += signal;
      if (!withSlopes) continue;
      byWire += density * wire.number;
      const Vector3d y = p.wire.inverse * off;
      for (std::size_t k = 0; k < 4; ++k)
        if (wire.of[k] != 0.0)
          for (Eigen::Index d = 0; d < 3; ++d)
            local.add(3 * static_cast<Eigen::Index>(wire.segment + k - 1) + d,
                      wire.of[k] * signal * y[d]);
      addBlur(p.wire, y, signal);
    }
    local.model = x[levelAt()] + (x[levelAt() + 1] - x[levelAt()]) * voxel.bone + local.metal;
    if (!withSlopes) return;
    local.add(wireAt(), byWire);
    local.add(levelAt(), 1.0 - voxel.bone);
    local.add(levelAt() + 1, voxel.bone);
    local.add(blurAt(), byInPlane);
    local.add(blurAt() + 1, byAxial);
    local.collect();
  }

  /// Residual of a voxel with the scanner's limit; 0 where both are beyond it.
  double residualOf(const FitVoxel& voxel, double model) const
  {
    if (voxel.intensity >= ceiling_) return std::max(0.0, ceiling_ - model);
    return voxel.intensity - model;
  }

  double varianceOf(double metal) const
  {
    const double signal = std::min(metal, ceiling_);
    return noise_ * noise_ + modelPart * modelPart * signal * signal;
  }

  /// Calls `add(residual, weight, slopes)` for every prior.
  template <class Add>
  void priors(const Eigen::VectorXd& x, Add add) const
  {
    std::vector<std::pair<Eigen::Index, double>> slope;
    const auto one = [&](Eigen::Index at, double value, double mean, double sd) {
      slope.assign(1, {at, 1.0});
      add(mean - value, 1.0 / (sd * sd), slope);
    };
    for (std::size_t i = 0; i + 1 < nodes_; ++i) {
      const Vector3d step = nodeOf(x, i + 1) - nodeOf(x, i);
      const double length = std::max(1e-6, step.norm());
      const bool isLead = i + 1 >= count_;
      const double chord = isLead ? leadStep_mm : chord_[i];
      const double sd = isLead ? 0.1 : chordSd_[i];
      slope.clear();
      for (Eigen::Index d = 0; d < 3; ++d) {
        slope.emplace_back(3 * static_cast<Eigen::Index>(i + 1) + d, step[d] / length);
        slope.emplace_back(3 * static_cast<Eigen::Index>(i) + d, -step[d] / length);
      }
      add(chord - length, 1.0 / (sd * sd), slope);
    }
    // smoothness: the third difference of four consecutive nodes with equal spacing
    for (std::size_t i = 0; i + 3 <= count_; ++i) {
      const double d = (nodeOf(x, i + 1) - nodeOf(x, i)).norm();
      const double e = (nodeOf(x, i + 3) - nodeOf(x, i + 2)).norm();
      if (i + 3 == count_ || std::fabs(d - e) > 0.3 * d) continue;  // the lead has another spacing
      constexpr double radius = 2.0;
      const double sd = 0.03 + 0.6 * d * d * d / (radius * radius);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto at = [&](std::size_t n) { return 3 * static_cast<Eigen::Index>(i + n) + axis; };
        slope = {{at(3), 1.0}, {at(2), -3.0}, {at(1), 3.0}, {at(0), -1.0}};
        add(-(x[at(3)] - 3.0 * x[at(2)] + 3.0 * x[at(1)] - x[at(0)]), 1.0 / (sd * sd), slope);
      }
    }
    // the lead goes on about straight
    for (std::size_t i = count_; i < nodes_; ++i)
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto n = static_cast<Eigen::Index>(i);
        const double last = (nodeOf(x, i - 1) - nodeOf(x, i - 2)).norm();
        const double ratio = leadStep_mm / std::max(0.2, last);
        const Eigen::Index a = 3 * (n - 2) + axis, b = 3 * (n - 1) + axis, c = 3 * n + axis;
        slope = {{c, 1.0}, {b, -1.0 - ratio}, {a, ratio}};
        add(-(x[c] - (1.0 + ratio) * x[b] + ratio * x[a]), 1.0 / (leadBend_mm * leadBend_mm),
            slope);
      }
    double mean = 0.0;
    for (std::size_t i = 0; i < count_; ++i)
      mean += x[amplitudeAt() + static_cast<Eigen::Index>(i)] / static_cast<double>(count_);
    const double spread = settings_.isSeenSingly ? amplitudeSpread : mergedSpread;
    for (std::size_t i = 0; i < count_; ++i)
      one(amplitudeAt() + static_cast<Eigen::Index>(i),
          x[amplitudeAt() + static_cast<Eigen::Index>(i)], mean, std::max(1.0, spread * mean));
    for (Eigen::Index i = 0; i < 2; ++i)
      one(blurAt() + i, x[blurAt() + i], guess_[i], blurSpread * guess_[i]);
    one(levelAt(), x[levelAt()], 50.0, 400.0);
    one(levelAt() + 1, x[levelAt() + 1], boneGuess(), 300.0);
    for (std::size_t i = 0; i < count_; ++i)
      if (i < settings_.isFixed.size() && settings_.isFixed[i])
        for (Eigen::Index d = 0; d < 3; ++d)
          one(3 * static_cast<Eigen::Index>(i) + d, x[3 * static_cast<Eigen::Index>(i) + d],
              chain_.position_P[i][d], keptSd_mm);
  }

  double boneGuess() const { return bone_; }

  System assemble(const Eigen::VectorXd& x, bool withSpread)
  {
    if (bone_ == 0.0) bone_ = x[levelAt() + 1];
    System system{Eigen::MatrixXd::Zero(size_, size_), Eigen::VectorXd::Zero(size_), 0.0};
    const auto add = [&](double residual, double weight,
                         const std::vector<std::pair<Eigen::Index, double>>& slope) {
      for (const auto& [i, a] : slope) {
        system.right[i] += weight * residual * a;
        for (const auto& [j, b] : slope)
          if (j <= i) system.left(i, j) += weight * a * b;  // of a symmetric matrix
      }
    };
    const Prepared p = prepare(x);
    const double independent = 1.0 / correlated();
    Local local(size_);
    std::vector<double> left;
    for (const FitVoxel& voxel : voxels_) {
      evaluate(x, p, voxel, true, local);
      const double residual = residualOf(voxel, local.model);
      if (voxel.intensity >= ceiling_ && residual == 0.0) continue;
      const double variance = varianceOf(local.metal);
      const double weight =
          (studentDegrees + 1.0) / (studentDegrees + residual * residual / variance) / variance;
      add(residual, weight * independent, local.slope);
      if (withSpread && local.metal < 3.0 * noise_) left.push_back(std::fabs(residual));
    }
    if (!left.empty()) {
      std::nth_element(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(left.size() / 2),
                       left.end());
      system.spread = left[left.size() / 2] / 0.6745;
    }
    priors(x, add);
    return system;
  }

  double assembleCost(const Eigen::VectorXd& x) const
  {
    const Prepared p = prepare(x);
    const double independent = 1.0 / correlated();
    Local local(size_);
    double cost = 0.0;
    for (const FitVoxel& voxel : voxels_) {
      evaluate(x, p, voxel, false, local);
      const double residual = residualOf(voxel, local.model);
      const double variance = varianceOf(local.metal);
      cost +=
          independent * ((studentDegrees + 1.0) *
                             logarithm(1.0 + residual * residual / (studentDegrees * variance)) +
                         logarithm(variance));
    }
    priors(x, [&](double residual, double weight, const auto&) {
      cost += weight * residual * residual;
    });
    return cost;
  }

  /// Voxels that share one noise, because the blur correlates it.
  double correlated() const
  {
    double voxels = 1.0;
    for (Eigen::Index i = 0; i < 3; ++i)
      voxels *= std::max(1.0, 2.0 * std::sqrt(pi) * 0.6 * guess_[0] / spacing_[i]);
    return isThinned(spacing_) ? std::max(1.0, voxels / keptOfThinned) : voxels;
  }

  FittedChain result()
  {
    setChords();
    const System system = assemble(x_, true);
    const Eigen::MatrixXd covariance =
        system.left.ldlt().solve(Eigen::MatrixXd::Identity(size_, size_));
    FittedChain fitted = chain_;
    fitted.covariance_P.clear();
    fitted.amplitude.clear();
    fitted.excess_mm.clear();
    for (std::size_t i = 0; i < nodes_; ++i) fitted.position_P[i] = nodeOf(x_, i);
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      const auto at = 3 * static_cast<Eigen::Index>(i);
      fitted.covariance_P.push_back(covariance.block<3, 3>(at, at));
      fitted.amplitude.push_back(x_[amplitudeAt() + static_cast<Eigen::Index>(i)]);
      if (i + 1 < count_) {
        const double excess = (fitted.position_P[i + 1] - fitted.position_P[i]).norm() - chord_[i];
        fitted.excess_mm.push_back(excess);
        const double off = excess / chordSd_[i];
        sum += off * off / static_cast<double>(count_ - 1);
      }
    }
    fitted.lengthMisfit = std::sqrt(sum);
    fitted.blurInPlane_mm = x_[blurAt()];
    fitted.blurAxial_mm = x_[blurAt() + 1];
    fitted.residual = noise_;
    fitted.cost = assembleCost(x_) + offsetCost_;
    return fitted;
  }

  const EarFrame& frame_;
  const electrode::ArrayDesign& array_;
  const std::vector<FitVoxel>& voxels_;
  const RefinementSettings& settings_;
  double ceiling_;
  std::size_t count_, nodes_;
  FittedChain chain_;
  Vector3d spacing_, normal_;
  Eigen::Vector2d guess_;
  Eigen::Index size_ = 0;
  Eigen::VectorXd x_;
  std::vector<WireSpot> wires_;
  std::vector<double> chord_, chordSd_;
  double wirePart_ = 0.0;  // of a contact's signal, in a millimeter of one wire
  double noise_ = 150.0, bone_ = 0.0, offset_ = contactOffset, offsetCost_ = 0.0;
};

}  // namespace

std::vector<FitVoxel> voxelsNear(const ct::CtVolume& volume, const EarFrame& frame,
                                 const std::vector<Vector3d>& points_P, double blur_mm)
{
  const Vector3d spacing = volume.spacing_mm();
  const bool isThin = isThinned(spacing);
  const auto& size = volume.size();
  const auto width = static_cast<std::size_t>(size[0]), height = static_cast<std::size_t>(size[1]);
  std::vector<std::size_t> marked;
  for (const Vector3d& point_P : points_P) {
    const Vector3d center = volume.toIndex(point_P);
    std::array<int, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      low[axis] = std::max(0, static_cast<int>(std::ceil(center[at] - fitReach_mm / spacing[at])));
      high[axis] = std::min(size[axis] - 1,
                            static_cast<int>(std::floor(center[at] + fitReach_mm / spacing[at])));
    }
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int i = low[0]; i <= high[0]; ++i)
          if ((!isThin || ((i + j) % 2 == 0 && (j + k) % 2 == 0)) &&
              (volume.toLps(Vector3d(i, j, k)) - point_P).norm() <= fitReach_mm)
            marked.push_back((static_cast<std::size_t>(k) * height + static_cast<std::size_t>(j)) *
                                 width +
                             static_cast<std::size_t>(i));
  }
  std::sort(marked.begin(), marked.end());
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
  std::vector<FitVoxel> voxels;
  for (const std::size_t cell : marked) {
    const std::int16_t value = volume.voxels()[cell];
    if (value == ct::unmeasured) continue;
    const Vector3d point = volume.toLps({static_cast<double>(cell % width),
                                         static_cast<double>((cell / width) % height),
                                         static_cast<double>(cell / (width * height))});
    voxels.push_back({point, static_cast<double>(value), frame.bonePart(point, blur_mm)});
  }
  return voxels;
}

FittedChain refined(const EarFrame& frame, const ct::CtVolume& volume, const MetalGrid& grid,
                    const Ear& ear, const std::vector<FitVoxel>& voxels,
                    const electrode::ArrayDesign& array, const FittedChain& start,
                    const RefinementSettings& settings)
{
  return Fit(frame, volume, grid, ear, voxels, array, start, settings).run();
}

}  // namespace perilymph::outcome
