// SPDX-License-Identifier: BSD-3-Clause
#include "CtPhantomAnatomy.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

constexpr double tableStep = 2.0 * pi / 180.0;
constexpr double fluid = 40.0, air = -1000.0, lamina = 1500.0;

/// Fraction of a voxel on the inner side of a wall at a distance.
double fraction(double distance, double cell)
{
  return std::clamp(0.5 + distance / cell, 0.0, 1.0);
}

double insideCapsuleShape(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, double radius)
{
  const Eigen::Vector3d along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return radius - (p - a - t * along).norm();
}

double insideRing(const Eigen::Vector3d& p, const Eigen::Vector3d& center,
                  const Eigen::Vector3d& axis, double ring, double tube)
{
  const Eigen::Vector3d off = p - center;
  const double up = off.dot(axis);
  const double out = (off - up * axis).norm() - ring;
  return tube - std::sqrt(up * up + out * out);
}

/// Height of a plane over the outer wall: constant, and slopes along x and y.
Eigen::Vector3d tiltTerms(double angle, double radius)
{
  return {1.0, radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

double Dice::uniform(double low, double high)
{
  const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
  return low + unit * (high - low);
}

double Dice::normal()
{
  const double length = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
  return length * std::cos(uniform(0.0, 2.0 * pi));
}

Wobble::Wobble(Dice& dice, double shortestPeriod_rad)
{
  for (std::size_t i = 0; i < 4; ++i) {
    frequency_[i] = dice.uniform(0.15, 2.0 * pi / shortestPeriod_rad);
    phase_[i] = dice.uniform(0.0, 2.0 * pi);
  }
}

double Wobble::operator()(double angle) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) sum += std::cos(frequency_[i] * angle + phase_[i]);
  return sum / std::sqrt(2.0);
}

PhantomAnatomy::PhantomAnatomy(std::uint64_t seed, const PhantomCondition& condition)
    : condition_(condition), first_(degrees(-13).si()), last_(degrees(870).si())
{
  Dice dice(seed);
  const auto sections = anatomy::loadMeasuredSections();
  if (!sections) throw std::runtime_error(sections.error().message);
  for (const auto& section : *sections) {
    angle_.push_back(section.angle);
    outer_.push_back(1e3 * section.outerRadius);
    width_.push_back(1e3 * (section.outerRadius - section.innerRadius));
    heightST_.push_back(1e3 * section.height);
    center_.push_back(1e3 * section.imaginary[4]);
  }
  // A and B vary by 5 % in the population, partly independently.
  size_ = 0.95 + 0.04 * dice.normal();
  stretch_ = 0.025 * dice.normal();
  rise_ = 1.0 + 0.10 * dice.normal();
  height_ = 0.86 + 0.06 * dice.normal();
  skew_ = 0.15 * dice.normal();
  last_ += degrees(25).si() * std::clamp(dice.normal(), -2.0, 2.0);
  if (condition.turns) last_ = 2.0 * pi * *condition.turns;
  for (int i = 0; i < 6; ++i) wobbles_.emplace_back(dice, i < 2 ? 2.6 : 3.5);
  for (auto& wave : waves_)
    wave = {dice.uniform(-1.5, 1.5), dice.uniform(-1.5, 1.5), dice.uniform(-1.5, 1.5),
            dice.uniform(0.0, 2.0 * pi)};
  capsule_ = 2050.0 + 100.0 * dice.normal();
  modiolus_ = dice.uniform(600.0, 1200.0);
  niche_ = dice.uniform(0.0, 1.0) < 0.6 ? air : fluid;
  canal_ = dice.uniform(0.5, 0.7);
  window_ = dice.uniform(0.6, 0.95);
  lean_ = Eigen::Vector3d(0.88, 0.3 + 0.4 * dice.normal(), -0.2 + 0.3 * dice.normal()).normalized();
  recess_ = std::clamp(0.04 + 0.07 * dice.normal(), -0.1, 0.25);
  for (int i = 0; i < 60; ++i)
    cells_.push_back({{dice.uniform(-11, 11), dice.uniform(-11, 11), dice.uniform(-9, 9)},
                      dice.uniform(0.4, 1.8)});

  // The tilt component of the rollercoaster would change the axis: it is removed, so that the axis
  // of the sections is unchanged.
  Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = 1; k < angle_.size() && angle_[k] < degrees(540).si(); ++k) {
    const Eigen::Vector3d terms = tiltTerms(angle_[k], outer_[k]);
    left += terms * terms.transpose();
    right += 0.12 * wobbles_[1](angle_[k]) * terms;
  }
  const Eigen::Vector3d tilt = left.inverse() * right;

  for (int i = 0; first_ + (i - 1) * tableStep <= last_; ++i) {
    const double angle = first_ + i * tableStep;
    std::size_t k = 0;
    while (k + 2 < angle_.size() && angle_[k + 1] < angle) ++k;
    const double t = (angle - angle_[k]) / (angle_[k + 1] - angle_[k]);
    const auto at = [&](const std::vector<double>& values) {
      // Beyond the last measured section the dimensions decrease slowly.
      const double beyond = std::max(0.0, angle - angle_.back());
      const double value = values[k] + std::min(t, 1.0) * (values[k + 1] - values[k]);
      return beyond > 0.0 ? values.back() * (1.0 - 0.13 * beyond) : value;
    };
    const double rollercoaster = 0.12 * wobbles_[1](angle) - tilt.dot(tiltTerms(angle, at(outer_)));
    const double outer =
        at(outer_) * size_ * (1.0 + stretch_ * std::cos(2.0 * angle) + 0.03 * wobbles_[0](angle));
    const double width = at(width_) * size_ * (1.02 + 0.07 * wobbles_[2](angle));
    double half = at(heightST_) * height_ * (1.0 + 0.09 * wobbles_[3](angle));
    if (angle < 0.4) half *= 1.0 - 0.25 * (0.4 - angle) / 0.6;
    double climb = angle > angle_.back()
                       ? center_.back() + 0.16 * (angle - angle_.back())
                       : center_[k] + std::min(t, 1.0) * (center_[k + 1] - center_[k]);
    KidneySection section{};
    section.outward = 0.45 * width;
    section.inward = 0.55 * width;
    section.middleRadius = outer - section.outward;
    section.half = half;
    section.middleHeight = rise_ * climb + 0.45 * at(heightST_) + rollercoaster;
    section.shear = 0.1 + skew_ + 0.06 * wobbles_[4](angle);
    section.bend = 0.06 * wobbles_[5](angle);
    // Both ends are rounded: the blind base over 8 degrees, the cupola over 50.
    const double toEnd =
        std::min((angle - first_) / degrees(8).si(), (last_ - angle) / degrees(50).si());
    const double x = 1.0 - std::clamp(toEnd, 0.0, 1.0);
    const double end = std::sqrt(std::max(0.01, 1.0 - x * x));
    section.outward *= end;
    section.inward *= end;
    section.half *= end;
    table_.push_back(section);
  }
  // It ends below the cupola.
  if (condition.turns) modiolusTop_ = std::min(modiolusTop_, sectionAt(last_).middleHeight);
}

KidneySection PhantomAnatomy::sectionAt(double angle) const
{
  const double x = std::max(0.0, (angle - first_) / tableStep);
  const auto i = std::min(static_cast<std::size_t>(x), table_.size() - 2);
  const double t = std::min(1.0, x - static_cast<double>(i));
  const KidneySection &a = table_[i], &b = table_[i + 1];
  const auto mix = [t](double from, double to) { return from + t * (to - from); };
  return {mix(a.middleRadius, b.middleRadius),
          mix(a.middleHeight, b.middleHeight),
          mix(a.outward, b.outward),
          mix(a.inward, b.inward),
          mix(a.half, b.half),
          mix(a.shear, b.shear),
          mix(a.bend, b.bend)};
}

PhantomAnatomy::Depth PhantomAnatomy::deepest(const Eigen::Vector3d& point_W) const
{
  const double r = point_W.head<2>().norm();
  double angle = std::atan2(point_W.y(), point_W.x());
  while (angle < first_ - 0.3) angle += 2.0 * pi;
  Depth deepest{-3.0, angle};
  for (; angle < last_ + 0.3; angle += 2.0 * pi) {
    const KidneySection section = sectionAt(angle);
    const double u = r - section.middleRadius;
    if (std::fabs(u) > 3.5) continue;
    const double v = point_W.z() - section.middleHeight - section.shear * u - section.bend * u * u;
    const double a = u > 0.0 ? section.outward : section.inward;
    const double f = std::sqrt(u * u / (a * a) + v * v / (section.half * section.half));
    if (f < 1e-6) return {section.half, angle};
    const double byU = (u / (a * a) - v / (section.half * section.half) *
                                          (section.shear + 2.0 * section.bend * u)) /
                       f;
    const double byV = v / (section.half * section.half) / f;
    // The wall is inclined to the half-plane where the radius decreases quickly.
    const KidneySection ahead = sectionAt(angle + 0.05);
    const double slope =
        (ahead.middleRadius + ahead.outward - section.middleRadius - section.outward) /
        (0.05 * std::max(0.3, r));
    const double norm = std::sqrt(byU * byU * (1.0 + slope * slope) + byV * byV);
    double depth = (1.0 - f) / std::max(norm, 0.2);
    const double beyond = std::max(first_ - angle, angle - last_);
    if (beyond > 0.0) depth = std::min(depth, -beyond * r);
    if (depth > deepest.inside) deepest = {depth, angle};
  }
  if (condition_.isCystic) {
    // Instead of the upper turns one cavity around the axis, above the last section.
    const KidneySection section = sectionAt(last_ - degrees(90).si());
    const double radius = section.middleRadius;
    const Eigen::Vector3d center(0.0, 0.0, section.middleHeight + 0.3);
    const double cavity = radius - (point_W - center).norm();
    if (cavity > deepest.inside) deepest = {cavity, last_};
  }
  return deepest;
}

Eigen::Vector3d PhantomAnatomy::roundWindow_W() const
{
  // On the outer wall of the lower scala, its membrane slightly behind the bone's edge.
  const KidneySection section = sectionAt(0.0);
  const double u = 0.866 * section.outward - recess_;
  return {section.middleRadius + u, 0.0,
          section.middleHeight - 0.5 * section.half + section.shear * u + section.bend * u * u};
}

double PhantomAnatomy::laminaAt(double angle) const
{
  // Room at the round window, where the kidneys are lower.
  if (condition_.hasRoomForArrays) return 0.15 + 0.4 * std::clamp((0.4 - angle) / 0.6, 0.0, 1.0);
  return -0.1;
}

double PhantomAnatomy::texture(const Eigen::Vector3d& p) const
{
  double sum = 0.0;
  for (const Eigen::Vector4d& wave : waves_) sum += std::cos(wave.head<3>().dot(p) + wave[3]);
  return sum / std::sqrt(3.0);
}

double PhantomAnatomy::surroundings(const Eigen::Vector3d& p, double inLumen, double cell) const
{
  // Otic capsule around the lumen, pneumatized bone of medium density beyond.
  // What has no share in a point is not calculated: textures are most of the work.
  const double dense = fraction(inLumen + 1.9, 0.6);
  double value = 0.0;
  if (dense > 0.0) value += dense * (capsule_ + 90.0 * texture(p));
  if (dense < 1.0) value += (1.0 - dense) * (1250.0 + 250.0 * texture(2.0 * p));
  // Modiolus: porous, a cone about the axis.
  const double cone = 1.15 - 0.32 * (p.z() + 0.5) - p.head<2>().norm();
  const double porous = p.z() > -0.6 && p.z() < modiolusTop_ ? fraction(cone, 3.0 * cell) : 0.0;
  if (porous > 0.0) value += porous * (modiolus_ + 150.0 * texture(5.0 * p) - value);
  // Internal auditory canal below it, facial canal beside.
  const double canal = insideCapsuleShape(p, {-0.3, 0.2, -3.0}, {-3.0, 4.0, -12.0}, 1.9);
  value += fraction(canal, cell) * (fluid - value);
  const double facial = insideCapsuleShape(p, {-4.0, -8.0, 2.0}, {6.0, -7.0, 0.5}, canal_);
  value += fraction(facial, cell) * (fluid - value);
  // Air cells keep a wall of 0.3 mm and a distance from the capsule.
  if (-1.3 - inLumen <= -cell) return value;
  for (const Ball& ball : cells_) {
    const double reach = ball.radius + cell;
    if ((p - ball.center).squaredNorm() > reach * reach) continue;
    const double in = std::min(ball.radius - (p - ball.center).norm(), -1.3 - inLumen);
    if (in > -cell) value += fraction(in, cell) * (air - value);
  }
  return value;
}

double PhantomAnatomy::intensity(const Eigen::Vector3d& p, double lumen, double cell) const
{
  const auto [depth, at] = deepest(p);
  double value = surroundings(p, depth, cell);
  // Vestibule, connected to the basal end, and two canals.
  const Eigen::Vector3d off = p - Eigen::Vector3d(4.5, -3.3, -0.6) * size_;
  const double ball = 1.0 - off.cwiseQuotient(Eigen::Vector3d(1.6, 1.7, 2.2) * size_).norm();
  const double canals =
      std::max(insideRing(p, Eigen::Vector3d(6.5, -6.5, -2.2), {0.1, 0.2, 0.97}, 2.9, 0.5),
               insideRing(p, Eigen::Vector3d(3.5, -6.5, -4.0), {0.8, 0.6, 0.0}, 3.0, 0.5));
  value += fraction(std::max(1.5 * ball, canals), cell) * (lumen - value);
  // Round-window niche, inclined apically, as in ears whose opening seen from the axis is ahead of
  // the marked center; beyond it the middle ear.
  const Eigen::Vector3d window = roundWindow_W();
  const double niche = std::max(insideCapsuleShape(p, window, window + 3.0 * lean_, window_),
                                2.2 - (p - window - 4.6 * lean_).norm());
  value += fraction(niche, cell) * (niche_ - value);
  // Finally the lumen, except for the spiral lamina.
  const double at_deg = inDegrees(radians(at));
  const bool isOssified = at_deg >= condition_.ossified[0] && at_deg < condition_.ossified[1];
  const double content =
      isOssified && depth > -cell ? capsule_ - 100.0 + 90.0 * texture(3.0 * p) : lumen;
  value += fraction(depth, cell) * (content - value);
  if (depth > 0.0 && !isOssified) {
    const double r = p.head<2>().norm();
    double angle = std::atan2(p.y(), p.x());
    while (angle < first_) angle += 2.0 * pi;
    for (; angle < last_ - 0.8; angle += 2.0 * pi) {
      const KidneySection section = sectionAt(angle);
      const double u = r - section.middleRadius;
      if (u > -0.1 * section.inward || u < -section.inward) continue;
      const double plate =
          laminaHalf_mm - std::fabs(p.z() - section.middleHeight - section.shear * u -
                                    laminaAt(angle) * section.half);
      value += fraction(plate, cell) * (lamina - value);
    }
  }
  return condition_.hasImplant ? withImplant(p, value, cell) : value;
}

double PhantomAnatomy::withImplant(const Eigen::Vector3d& p, double value, double cell) const
{
  constexpr double wire = 5000.0, contact = 14000.0, end = 400.0 * pi / 180.0;
  constexpr double betweenContacts = 24.0 * pi / 180.0;
  const double r = p.head<2>().norm();
  double angle = std::atan2(p.y(), p.x());
  while (angle < 0.0) angle += 2.0 * pi;
  for (; angle < end; angle += 2.0 * pi) {
    const KidneySection section = sectionAt(angle);
    const double u = r - section.middleRadius - 0.1 * section.outward;
    const double v = p.z() - section.middleHeight + 0.4 * section.half;
    const double along = r * (angle - betweenContacts * std::round(angle / betweenContacts));
    const double across = std::sqrt(u * u + v * v);
    value += fraction(0.18 - across, cell) * (wire - value);
    value += fraction(0.4 - std::hypot(across, along), cell) * (contact - value);
  }
  return value;
}

}  // namespace perilymph::test
