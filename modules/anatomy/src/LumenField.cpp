#include "LumenField.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "CubicTable.h"
#include "WallLines.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

constexpr double sectionStep_deg = 3.0;
constexpr int across = 46;       // samples over a section, each way
constexpr double margin = 1.25;  // the table goes this many half widths and heights out
constexpr int outlinePoints = WallLines::points;

// Lead-in and spiral both describe the wall this far beyond their joint. A point changes over only
// where it leaves that overlap, so it never changes back within a step.
constexpr double joint = 0.05e-3;  // [m]

constexpr std::size_t page = across * across;               // samples of a section
constexpr double perShare = (across - 3) / (2.0 * margin);  // samples per unit of share

double at(const std::vector<double>& coefficients, std::size_t first,
          const double weights[4]) noexcept
{
  return weighted(coefficients.data() + first, weights);
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

/// A point in the section's coordinates, with their gradients in space.
struct LumenField::Unrolled {
  std::size_t section;  // first of four coefficients over the angle
  double sectionFraction;
  double u, v;               // from the section's center, outward and apical [m]
  double p, q;               // the same as shares of half width and half height
  double width, height;      // half of the section's [m]
  Eigen::Vector3d byAngle;   // gradient of the angle [1/m]
  Eigen::Vector3d byP, byQ;  // gradients of the shares [1/m]
};

LumenField::LumenField(const ScalaTympani& scala) : entry_(scala.entry()), inward_W_(-entry_.out_W)
{
  lastAngle_ = scala.lastAngle().si();
  sections_ = static_cast<int>(std::lround(inDegrees(scala.lastAngle()) / sectionStep_deg)) + 1;
  const double step = lastAngle_ / (sections_ - 1);
  perSection_ = 1.0 / step;

  std::vector<double> radius, height, halfWidth, halfHeight, inner, outer, roof;
  for (int i = 0; i < sections_; ++i) {
    const double angle = step * i;
    const Eigen::Vector3d center = scala.center_W(angle);
    const SineCosine turn = sineCosine(angle);
    double width = 0.0, tall = 0.0;
    for (int k = 0; k < outlinePoints; ++k) {
      const Eigen::Vector3d e = scala.wall_W(angle, 2.0 * pi * k / outlinePoints) - center;
      width = std::max(width, std::fabs(e.x() * turn.cosine + e.y() * turn.sine));
      tall = std::max(tall, std::fabs(e.z()));
    }
    radius.push_back(center.x() * turn.cosine + center.y() * turn.sine);
    height.push_back(center.z());
    halfWidth.push_back(width);
    halfHeight.push_back(tall);
    const auto edge = [&](double share) {
      const Eigen::Vector3d e = scala.membrane_W(angle, share) - center;
      return e.x() * turn.cosine + e.y() * turn.sine;
    };
    inner.push_back(edge(0.0));
    outer.push_back(edge(1.0));
    roof.push_back((scala.membrane_W(angle, 0.5) - center).z());
  }
  centerRadius_ = interpolatingCoefficients(radius);
  centerHeight_ = interpolatingCoefficients(height);
  halfWidth_ = interpolatingCoefficients(halfWidth);
  halfHeight_ = interpolatingCoefficients(halfHeight);
  membraneInner_ = interpolatingCoefficients(inner);
  membraneOuter_ = interpolatingCoefficients(outer);
  membraneHeight_ = interpolatingCoefficients(roof);

  leastRadius_.resize(static_cast<std::size_t>(sections_));
  leastSlant_.resize(static_cast<std::size_t>(sections_));
  distance_.resize((static_cast<std::size_t>(sections_) + 2) * page);
  for (int i = 0; i < sections_; ++i) fillSection(scala, i);
  continueIntoLeadIn();
  // beyond the last section the distances go on as parabolas through the last three
  float* last = distance_.data() + (static_cast<std::size_t>(sections_) + 1) * page;
  for (std::size_t k = 0; k < page; ++k)
    last[k] = 3.0f * ((last - page)[k] - (last - 2 * page)[k]) + (last - 3 * page)[k];
}

// The page before the first section, so that there the distance changes with the angle as it does
// in the straight lead-in: not at all along its axis.
void LumenField::continueIntoLeadIn()
{
  const CubicWeights start(0.0);
  const auto slope = [&](const std::vector<double>& table) {
    return at(table, 0, start.slope) * perSection_;
  };
  const double width = at(halfWidth_, 0, start.value);
  const double tall = at(halfHeight_, 0, start.value);
  const double radius = at(centerRadius_, 0, start.value);
  float* before = distance_.data();
  const float* first = before + page;
  const auto difference = [](const float* row, int i, int step) {
    const int low = std::max(i - 1, 0), high = std::min(i + 1, across - 1);
    return static_cast<double>(row[high * step] - row[low * step]) * perShare / (high - low);
  };
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j) {
      const double p = (i - 1) / perShare - margin;
      const double q = (j - 1) / perShare - margin;
      const double byP = difference(first + j, i, across);
      const double byQ = difference(first + i * across, j, 1);
      // The place (p, q) moves with the section; along the axis it would move by the tangent.
      const double perAngle = (radius + p * width) / inward_W_.y();
      const double moveU = slope(centerRadius_) + p * slope(halfWidth_) - perAngle * inward_W_.x();
      const double moveV = slope(centerHeight_) + q * slope(halfHeight_) - perAngle * inward_W_.z();
      const double byAngle = byP * moveU / width + byQ * moveV / tall;
      const int k = i * across + j;
      before[k] = static_cast<float>((first + page)[k] - 2.0 * byAngle / perSection_);
    }
}

// The distances of one section, from its outline and the direction in which the wall runs on.
void LumenField::fillSection(const ScalaTympani& scala, int section)
{
  const double angle = section / perSection_;
  const Eigen::Vector3d center = scala.center_W(angle);
  const WallLines lines(scala, angle);
  const auto row = static_cast<std::size_t>(section);
  leastRadius_[row] = lines.leastRadius();
  leastSlant_[row] = lines.leastSlant();

  // the last section is the far end of the last piece
  const std::size_t piece = std::min(row, static_cast<std::size_t>(sections_) - 2);
  const CubicWeights here(static_cast<double>(row - piece));
  const double width = at(halfWidth_, piece, here.value);
  const double tall = at(halfHeight_, piece, here.value);
  float* distances = distance_.data() + (row + 1) * page;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = ((i - 1) / perShare - margin) * width;
      const double v = ((j - 1) / perShare - margin) * tall;
      const double off = std::sqrt(u * u + v * v);
      const Eigen::Vector3d wall = scala.wall_W(angle, arcTangent(v, u)) - center;
      const double edge =
          std::sqrt(wall.x() * wall.x() + wall.y() * wall.y() + wall.z() * wall.z());
      const double distance = lines.distance(u, v);
      distances[i * across + j] = static_cast<float>(off < edge ? distance : -distance);
    }
}

LumenField::Unrolled LumenField::unroll(const Eigen::Vector3d& point_W, const LumenTrack& track,
                                        bool inLeadIn) const noexcept
{
  Unrolled at_;
  const double index = std::min(track.angle, lastAngle_) * perSection_;
  at_.section = std::min(static_cast<std::size_t>(std::max(index, 0.0)),
                         static_cast<std::size_t>(sections_ - 2));
  at_.sectionFraction = index - static_cast<double>(at_.section);
  const CubicWeights along(at_.sectionFraction);
  const double centerRadius = at(centerRadius_, at_.section, along.value);
  const double centerHeight = at(centerHeight_, at_.section, along.value);
  at_.width = at(halfWidth_, at_.section, along.value);
  at_.height = at(halfHeight_, at_.section, along.value);

  Eigen::Vector3d byU, byV;
  if (inLeadIn) {
    // the section slides along the straight axis
    const double forward = point_W.y() / inward_W_.y();
    at_.u = point_W.x() - forward * inward_W_.x() - centerRadius;
    at_.v = point_W.z() - forward * inward_W_.z() - centerHeight;
    byU = {1.0, -inward_W_.x() / inward_W_.y(), 0.0};
    byV = {0.0, -inward_W_.z() / inward_W_.y(), 1.0};
    at_.byAngle.setZero();
  } else {
    // the section turns with the angle
    const double r = point_W.x() * track.direction[0] + point_W.y() * track.direction[1];
    at_.u = r - centerRadius;
    at_.v = point_W.z() - centerHeight;
    const double perAngle = track.angle > lastAngle_ ? 0.0 : 1.0 / std::max(r, 1e-5);
    at_.byAngle = {-track.direction[1] * perAngle, track.direction[0] * perAngle, 0.0};
    byU = Eigen::Vector3d(track.direction[0], track.direction[1], 0.0) -
          (at(centerRadius_, at_.section, along.slope) * perSection_) * at_.byAngle;
    byV = Eigen::Vector3d(0.0, 0.0, 1.0) -
          (at(centerHeight_, at_.section, along.slope) * perSection_) * at_.byAngle;
  }
  at_.p = at_.u / at_.width;
  at_.q = at_.v / at_.height;
  at_.byP = (byU - (at_.p * at(halfWidth_, at_.section, along.slope) * perSection_) * at_.byAngle) /
            at_.width;
  at_.byQ =
      (byV - (at_.q * at(halfHeight_, at_.section, along.slope) * perSection_) * at_.byAngle) /
      at_.height;
  return at_;
}

void LumenField::locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& track,
                        WallPoint& wall) const noexcept
{
  wall.isNear = false;
  if (!((point_W - entry_.origin_W).dot(inward_W_) >= 0.0)) {  // outside, or not a number
    track = LumenTrack{};
    return;
  }

  // the angle, in the turn the point remembers
  const bool isFirstTurn = track.angle < 0.5 * pi && point_W.x() > 0.0;
  if (track.inLeadIn && (point_W.y() > joint || !isFirstTurn)) track.inLeadIn = false;
  if (isFirstTurn && point_W.y() < -joint) track.inLeadIn = true;
  if (track.inLeadIn) {
    track = LumenTrack{};
  } else {
    const double r = std::sqrt(point_W.x() * point_W.x() + point_W.y() * point_W.y());
    if (!(r > 1e-6)) return;  // on the modiolar axis: no angle, and no wall near
    const double x = point_W.x() / r;
    const double y = point_W.y() / r;
    track.angle += arcTangent(y * track.direction[0] - x * track.direction[1],
                              x * track.direction[0] + y * track.direction[1]);
    track.direction[0] = x;
    track.direction[1] = y;
  }
  const bool inLeadIn = track.inLeadIn;
  const Unrolled here = unroll(point_W, track, inLeadIn);

  // far from every wall of the section: that is all anyone asks
  const double toEnd =
      (lastAngle_ - track.angle) * std::sqrt(point_W.x() * point_W.x() + point_W.y() * point_W.y());
  const double clear = 0.95 * leastRadius_[here.section] - reach / leastSlant_[here.section];
  if (clear > 0.0 && here.u * here.u + here.v * here.v < clear * clear && toEnd > reach) return;

  // the spline's value, gradient and second derivatives at (angle, p, q)
  const double pAsked = (here.p + margin) * perShare;
  const double qAsked = (here.q + margin) * perShare;
  const double pIndex = std::clamp(pAsked, 0.0, across - 3.001);
  const double qIndex = std::clamp(qAsked, 0.0, across - 3.001);
  const auto pFirst = static_cast<std::size_t>(pIndex);
  const auto qFirst = static_cast<std::size_t>(qIndex);
  const CubicWeights a(here.sectionFraction);
  const CubicWeights p(pIndex - static_cast<double>(pFirst));
  const CubicWeights q(qIndex - static_cast<double>(qFirst));
  double D = 0.0, Da = 0.0, Dp = 0.0, Dq = 0.0, Dpp = 0.0, Dpq = 0.0, Dqq = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double value = 0.0, byP = 0.0, byPp = 0.0, byQ = 0.0, byPq = 0.0, byQq = 0.0;
    for (std::size_t j = 0; j < 4; ++j) {
      const float* row =
          distance_.data() + ((here.section + i) * across + pFirst + j) * across + qFirst;
      const double c0 = row[0], c1 = row[1], c2 = row[2], c3 = row[3];
      const double v = c0 * q.value[0] + c1 * q.value[1] + c2 * q.value[2] + c3 * q.value[3];
      const double s = c0 * q.slope[0] + c1 * q.slope[1] + c2 * q.slope[2] + c3 * q.slope[3];
      const double b = c0 * q.bend[0] + c1 * q.bend[1] + c2 * q.bend[2] + c3 * q.bend[3];
      value += p.value[j] * v;
      byP += p.slope[j] * v;
      byPp += p.bend[j] * v;
      byQ += p.value[j] * s;
      byPq += p.slope[j] * s;
      byQq += p.value[j] * b;
    }
    D += a.value[i] * value;
    Da += a.slope[i] * value;
    Dp += a.value[i] * byP;
    Dq += a.value[i] * byQ;
    Dpp += a.value[i] * byPp;
    Dpq += a.value[i] * byPq;
    Dqq += a.value[i] * byQq;
  }

  // beyond the table the distance goes on as it left it
  D += (pAsked - pIndex) * Dp + (qAsked - qIndex) * Dq;
  wall.distance = D;
  if (std::min(D, toEnd) > reach) return;
  wall.isNear = true;
  wall.normal_W =
      (Da * perSection_) * here.byAngle + (Dp * perShare) * here.byP + (Dq * perShare) * here.byQ;

  // how the normal turns: in the section by the spline, along the duct by the circle around the
  // axis
  const double perShare2 = perShare * perShare;
  double pp = -Dpp * perShare2 / (here.width * here.width);
  double pq = -Dpq * perShare2 / (here.width * here.height);
  double qq = -Dqq * perShare2 / (here.height * here.height);
  keepPositive(pp, pq, qq);
  const Eigen::Vector3d u = here.width * here.byP;
  const Eigen::Vector3d v = here.height * here.byQ;
  const Eigen::Vector3d pu = pp * u + pq * v;
  const Eigen::Vector3d qv = pq * u + qq * v;
  wall.turning_W = u * pu.transpose() + v * qv.transpose();
  if (!inLeadIn) {
    const Eigen::Vector3d outward(track.direction[0], track.direction[1], 0.0);
    const double inwardPush = -wall.normal_W.dot(outward);
    if (inwardPush > 0.0) {
      const double r = std::max(point_W.dot(outward), 1e-4);
      const Eigen::Vector3d forward(-track.direction[1], track.direction[0], 0.0);
      wall.turning_W += (inwardPush / r) * forward * forward.transpose();
    }
  }

  // whether the foot lies on the basilar membrane
  const double footV = here.v - D * wall.normal_W.z();
  const double footU = here.u - D * (wall.normal_W.x() * track.direction[0] +
                                     wall.normal_W.y() * track.direction[1]);
  wall.onMembrane = footV > 0.8 * at(membraneHeight_, here.section, a.value) &&
                    footU > at(membraneInner_, here.section, a.value) &&
                    footU < at(membraneOuter_, here.section, a.value);

  // the apex: the last section is a wall across the duct
  if (toEnd < D) {
    wall.distance = toEnd;
    wall.normal_W = Eigen::Vector3d(track.direction[1], -track.direction[0], 0.0);
    wall.turning_W.setZero();
    wall.onMembrane = false;
  }
}

}  // namespace perilymph::anatomy
