// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/LumenField.h"

#include <algorithm>
#include <cmath>

#include "lumen/TrustRadius.h"
#include "numerics/CubicBlock.h"
#include "numerics/CubicTable.h"
#include "perilymph/foundation/Four.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

// Lead-in and spiral overlap by this length beyond their joint. A point switches only when it
// leaves the overlap, so it never switches back within a step.
constexpr double joint = 0.05e-3;  // [m]

// Bound of the slope of the table's distance (measured: at most 1.06 except for one point in 500):
// a point may safely move by a distance divided by it.
constexpr double steepest = 1.25;

/// Angle from one unit vector to another [rad]. Between two ticks it is small: the first terms of
/// the arcsine series are then exact to 1e-15.
double angleBetween(const double from[2], const double to[2]) noexcept
{
  const double sine = to[1] * from[0] - to[0] * from[1];
  const double cosine = to[0] * from[0] + to[1] * from[1];
  if (cosine > 0.0 && std::fabs(sine) < 0.01) {
    const double s2 = sine * sine;
    return sine + sine * s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0));
  }
  return arcTangent(sine, cosine);
}

/// The positive semidefinite part of [a b; b c].
void keepPositive(double& a, double& b, double& c) noexcept
{
  const double middle = 0.5 * (a + c);
  const double spread = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  const double low = middle - spread;
  const double high = middle + spread;
  if (low >= 0.0) return;
  if (high <= 0.0) {
    a = b = c = 0.0;
    return;
  }
  const double scale = high / (high - low);
  a = scale * (a - low);
  b = scale * b;
  c = scale * (c - low);
}

}  // namespace

/// A point in the section's coordinates, with their spatial gradients.
struct LumenField::Unrolled {
  explicit Unrolled(double sectionFraction) : weights(sectionFraction) {}

  std::size_t section = 0;            // first of four coefficients over the angle
  CubicWeights weights;               // of those four
  double slope[4] = {};               // of center, half width and half height, by the angle [m]
  std::size_t cell = 0;               // first coefficient of the block around the point
  bool isInTable = false;             // otherwise extrapolated
  double r = 0;                       // from the modiolar axis; 0 in the lead-in [m]
  double u = 0, v = 0;                // from the section's center, outward and apical [m]
  double p = 0, q = 0;                // the same relative to half width and half height
  double width = 0;                   // half width of the section [m]
  double height = 0;                  // half height of the section [m]
  double pByAngle = 0, qByAngle = 0;  // derivatives of p and q by the angle
  Eigen::Vector3d byAngle;            // gradient of the angle [1/m]
  Eigen::Vector3d byP, byQ;           // gradients of p and q [1/m]
};

// The angle of a point, in the turn stored in its track. False on the modiolar axis, where it is
// undefined.
bool LumenField::track(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept
{
  const bool isFirstTurn = track.angle < 0.5 * pi && point_W.x() > 0.0;
  if (track.inLeadIn && (point_W.y() > joint || !isFirstTurn)) track.inLeadIn = false;
  if (isFirstTurn && point_W.y() < -joint) track.inLeadIn = true;
  if (track.inLeadIn) {
    track = LumenTrack{};
    return true;
  }
  const double r = std::sqrt(point_W.x() * point_W.x() + point_W.y() * point_W.y());
  if (!(r > 1e-6)) return false;
  const double perR = 1.0 / r;
  const double direction[2] = {point_W.x() * perR, point_W.y() * perR};
  track.angle += angleBetween(track.direction, direction);
  track.direction[0] = direction[0];
  track.direction[1] = direction[1];
  return true;
}

LumenField::Unrolled LumenField::unroll(const Eigen::Vector3d& point_W,
                                        const LumenTrack& track) const noexcept
{
  const double index = std::min(track.angle, lastAngle_) * perSection_;
  const std::size_t section = std::min(static_cast<std::size_t>(std::max(index, 0.0)),
                                       static_cast<std::size_t>(sections_ - 2));
  Unrolled at(index - static_cast<double>(section));
  at.section = section;

  // center, half width and half height of the section, and their slopes by the angle
  double value[4];
  withLanes([&]() PERILYMPH_KERNEL {
    Four sums{}, slopes{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Four row = load<Four>(along_[section + k].data(), 0);
      sums += at.weights.value[k] * row;
      slopes += at.weights.slope[k] * row;
    }
    store(sums, value, 0);
    store(Four{slopes * perSection_}, at.slope, 0);
  });
  at.width = value[halfWidth];
  at.height = value[halfHeight];
  const double perWidth = 1.0 / at.width;
  const double perHeight = 1.0 / at.height;

  if (track.inLeadIn) {
    // the section moves along the straight axis
    const double slantX = inward_W_.x() / inward_W_.y();
    const double slantZ = inward_W_.z() / inward_W_.y();
    at.u = point_W.x() - point_W.y() * slantX - value[centerRadius];
    at.v = point_W.z() - point_W.y() * slantZ - value[centerHeight];
    at.p = at.u * perWidth;
    at.q = at.v * perHeight;
    at.byAngle.setZero();
    at.byP = {perWidth, -slantX * perWidth, 0.0};
    at.byQ = {0.0, -slantZ * perHeight, perHeight};
    return at;
  }
  // the section rotates and changes with the angle
  const double* outward = track.direction;
  const double r = point_W.x() * outward[0] + point_W.y() * outward[1];
  at.r = r;
  at.u = r - value[centerRadius];
  at.v = point_W.z() - value[centerHeight];
  at.p = at.u * perWidth;
  at.q = at.v * perHeight;
  const double perAngle = track.angle > lastAngle_ ? 0.0 : 1.0 / std::max(r, 1e-5);
  at.byAngle = {-outward[1] * perAngle, outward[0] * perAngle, 0.0};
  at.pByAngle = -(at.slope[centerRadius] + at.p * at.slope[halfWidth]) * perWidth;
  at.qByAngle = -(at.slope[centerHeight] + at.q * at.slope[halfHeight]) * perHeight;
  at.byP = {outward[0] * perWidth + at.pByAngle * at.byAngle[0],
            outward[1] * perWidth + at.pByAngle * at.byAngle[1], 0.0};
  at.byQ = {at.qByAngle * at.byAngle[0], at.qByAngle * at.byAngle[1], perHeight};
  return at;
}

CubicBlock LumenField::distanceAt(Unrolled& at) const noexcept
{
  const double pRequested = (at.p + margin) * samplesPerUnit;
  const double qRequested = (at.q + margin) * samplesPerUnit;
  const double pIndex = std::clamp(pRequested, 0.0, across - 3.001);
  const double qIndex = std::clamp(qRequested, 0.0, across - 3.001);
  const auto pFirst = static_cast<std::size_t>(pIndex);
  const auto qFirst = static_cast<std::size_t>(qIndex);
  const CubicWeights p(pIndex - static_cast<double>(pFirst));
  const CubicWeights q(qIndex - static_cast<double>(qFirst));

  at.cell = (at.section * across + pFirst) * across + qFirst;
  at.isInTable = pRequested == pIndex && qRequested == qIndex;
  CubicBlock spline(distance_.data() + at.cell, page, across, at.weights, p, q);
  // beyond the table: linear extrapolation
  spline.value += (pRequested - pIndex) * spline.byP + (qRequested - qIndex) * spline.byQ;
  return spline;
}

void LumenField::follow(const Eigen::Vector3d& point_W, LumenTrack& memory) const noexcept
{
  if (behindOpening(entry_, point_W, memory) >= 0.0)
    track(point_W, memory);
  else
    memory = LumenTrack{};
}

void LumenField::locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& memory,
                        WallPoint& wall) const noexcept
{
  wall.isNear = false;
  wall.clearance = 0.0;
  const double inside = behindOpening(entry_, point_W, memory);
  if (!(inside >= 0.0)) {  // outside or NaN
    memory = LumenTrack{};
    wall.clearance = -inside;
    return;
  }
  if (!track(point_W, memory)) return;  // no wall is near the axis
  Unrolled here = unroll(point_W, memory);

  // farther than `reach` from every wall of the section: only the clearance is needed
  const double toEnd = (lastAngle_ - memory.angle) *
                       std::sqrt(point_W.x() * point_W.x() + point_W.y() * point_W.y());
  const double slant = minSlant_[here.section];
  const double clear = 0.95 * minRadius_[here.section] - reach / slant;
  const double off2 = here.u * here.u + here.v * here.v;
  // the chord to the end is at least 2/pi of the arc, up to half a turn
  const double clearOfEnd = 0.5 * toEnd - reach;
  if (clear > 0.0 && off2 < clear * clear && toEnd > reach) {
    wall.clearance = std::min((clear - std::sqrt(off2)) * slant, clearOfEnd);
    return;
  }

  const CubicBlock spline = distanceAt(here);
  wall.distance = spline.value;
  if (std::min(spline.value, toEnd) > reach) {
    wall.clearance = std::min((spline.value - reach) / steepest, clearOfEnd);
    return;
  }
  wall.isNear = true;
  wall.normal_W = (spline.byA * perSection_) * here.byAngle +
                  (spline.byP * samplesPerUnit) * here.byP +
                  (spline.byQ * samplesPerUnit) * here.byQ;
  setTurning(point_W, memory, here, spline, wall);
  setHessian(memory, here, spline, wall);
  // the wall across the duct is out of reach for as long
  wall.trustRadius = std::min(wall.trustRadius, std::max((toEnd - spline.value) / 3.0, 0.0));
  wall.onMembrane = isOnMembrane(memory, here, wall);

  // the apex: the last section is a wall across the duct
  if (toEnd < spline.value) {
    wall.distance = toEnd;
    wall.normal_W = Eigen::Vector3d(memory.direction[1], -memory.direction[0], 0.0);
    wall.shapeOperator_W.setZero();
    wall.trustRadius = 0.0;
    wall.onMembrane = false;
  }
}

// Sets the shape operator: within the section from the spline, along the duct from the circle
// around the axis.
void LumenField::setTurning(const Eigen::Vector3d& point_W, const LumenTrack& track,
                            const Unrolled& at, const CubicBlock& spline,
                            WallPoint& wall) const noexcept
{
  const double perWidth = samplesPerUnit / at.width;
  const double perHeight = samplesPerUnit / at.height;
  double pp = -spline.byPp * perWidth * perWidth;
  double pq = -spline.byPq * perWidth * perHeight;
  double qq = -spline.byQq * perHeight * perHeight;
  keepPositive(pp, pq, qq);
  const Eigen::Vector3d u = at.width * at.byP;
  const Eigen::Vector3d v = at.height * at.byQ;
  double forward[3] = {-track.direction[1], track.direction[0], 0.0};
  double around = 0.0;
  if (!track.inLeadIn) {
    const double inwardPush =
        -(wall.normal_W.x() * track.direction[0] + wall.normal_W.y() * track.direction[1]);
    const double r = point_W.x() * track.direction[0] + point_W.y() * track.direction[1];
    if (inwardPush > 0.0) around = inwardPush / std::max(r, 1e-4);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const double operatorAt = pp * u[i] * u[j] + pq * (u[i] * v[j] + v[i] * u[j]) +
                                qq * v[i] * v[j] + around * forward[i] * forward[j];
      wall.shapeOperator_W(i, j) = operatorAt;
      wall.shapeOperator_W(j, i) = operatorAt;
    }
}

// Sets the Hessian by the chain rule in cylindrical coordinates (r, angle, z), in which the section's
// coordinates p and q depend on the angle with its center and size; in the lead-in it is constant
// along the axis.
void LumenField::setHessian(const LumenTrack& track, const Unrolled& at, const CubicBlock& spline,
                            WallPoint& wall) const noexcept
{
  const double perWidth = 1.0 / at.width, perHeight = 1.0 / at.height;
  const double s = samplesPerUnit;
  const double fp = s * spline.byP, fq = s * spline.byQ;
  const double fpp = s * s * spline.byPp, fpq = s * s * spline.byPq, fqq = s * s * spline.byQq;
  Eigen::Matrix3d& hessian = wall.hessian_W;
  double perRadius = 0.0;
  if (track.inLeadIn) {
    hessian = fpp * at.byP * at.byP.transpose() + fqq * at.byQ * at.byQ.transpose() +
              fpq * (at.byP * at.byQ.transpose() + at.byQ * at.byP.transpose());
  } else {
    double bend[4];  // second derivatives of center, half width and half height
    withLanes([&]() PERILYMPH_KERNEL {
      Four sums{};
      for (std::size_t k = 0; k < 4; ++k)
        sums += at.weights.bend[k] * load<Four>(along_[at.section + k].data(), 0);
      store(Four{sums * (perSection_ * perSection_)}, bend, 0);
    });
    const double fa = perSection_ * spline.byA;
    const double fap = perSection_ * s * spline.byAp, faq = perSection_ * s * spline.byAq;
    const double faa = perSection_ * perSection_ * spline.byAa;

    // derivatives of p and q by the angle
    const double p1 = at.pByAngle, q1 = at.qByAngle;
    const double p2 =
        -(bend[centerRadius] + 2.0 * p1 * at.slope[halfWidth] + at.p * bend[halfWidth]) * perWidth;
    const double q2 =
        -(bend[centerHeight] + 2.0 * q1 * at.slope[halfHeight] + at.q * bend[halfHeight]) *
        perHeight;

    const double byR = fp * perWidth;
    double byAngle = fa + fp * p1 + fq * q1;
    double angleR = (fap + fpp * p1 + fpq * q1 - fp * at.slope[halfWidth] * perWidth) * perWidth;
    double angleZ = (faq + fpq * p1 + fqq * q1 - fq * at.slope[halfHeight] * perHeight) * perHeight;
    double angleAngle = faa + 2.0 * (fap * p1 + faq * q1) + fpp * p1 * p1 + 2.0 * fpq * p1 * q1 +
                        fqq * q1 * q1 + fp * p2 + fq * q2;
    if (track.angle > lastAngle_) byAngle = angleR = angleZ = angleAngle = 0.0;

    perRadius = 1.0 / std::max(at.r, 1e-5);
    const double rr = fpp * perWidth * perWidth;
    const double zz = fqq * perHeight * perHeight;
    const double rz = fpq * perWidth * perHeight;
    const double ra = (angleR - byAngle * perRadius) * perRadius;
    const double az = angleZ * perRadius;
    const double aa = (angleAngle * perRadius + byR) * perRadius;
    const double x = track.direction[0], y = track.direction[1];
    hessian(0, 0) = rr * x * x - 2.0 * ra * x * y + aa * y * y;
    hessian(1, 1) = rr * y * y + 2.0 * ra * x * y + aa * x * x;
    hessian(0, 1) = hessian(1, 0) = (rr - aa) * x * y + ra * (x * x - y * y);
    hessian(0, 2) = hessian(2, 0) = rz * x - az * y;
    hessian(1, 2) = hessian(2, 1) = rz * y + az * x;
    hessian(2, 2) = zz;
  }
  if (!at.isInTable) {
    wall.trustRadius = 0.0;
    return;
  }
  // the directions of the Hessian rotate with the angle
  const std::uint8_t level = trustLevel(3.0 * perRadius * hessian.norm());
  wall.trustRadius = trustRadii[std::min(trust_[at.cell], level)];
}

// True if the nearest point of the wall lies on the basilar membrane.
bool LumenField::isOnMembrane(const LumenTrack& track, const Unrolled& at,
                              const WallPoint& wall) const noexcept
{
  const double footV = at.v - wall.distance * wall.normal_W.z();
  if (!(footV > 0.0)) return false;  // the membrane is in the roof
  const double footU = at.u - wall.distance * (wall.normal_W.x() * track.direction[0] +
                                               wall.normal_W.y() * track.direction[1]);
  const double* weights = at.weights.value;
  return footV > 0.8 * along(membraneHeight, at.section, weights) &&
         footU > along(membraneInner, at.section, weights) &&
         footU < along(membraneOuter, at.section, weights);
}

}  // namespace perilymph::anatomy
