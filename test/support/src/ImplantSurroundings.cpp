// SPDX-License-Identifier: BSD-3-Clause
#include "ImplantSurroundings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

// Boxes of a millimeter around the cochlea.
constexpr int boxes = 40;
constexpr double box_mm = 1.0, halfWidth_mm = 0.5 * boxes * box_mm;
const Eigen::Vector3d middle_W(1.2, -0.4, 0.6);

constexpr double air = -1000.0;
// Polydimethylsiloxane of 1.1 g/cm^3: 37.9 % of silicon, the rest attenuating as water, by NIST's tables at
// 60 and 80 keV +280 and +170 HU. Confidence medium.
constexpr double silicone = 230.0;
constexpr double wireArea_mm2 = 0.25 * pi * 0.025 * 0.025;
constexpr double leadRadius_mm = 0.5;  // choice, low

double part(double depth, double cell) { return std::clamp(0.5 + depth / cell, 0.0, 1.0); }

}  // namespace

ImplantSurroundings::ImplantSurroundings(EarContent ear, const electrode::ArrayDesign& array,
                                         const Course& course, bool hasOldLead, std::uint64_t seed)
    : ear_(std::move(ear)), near_(static_cast<std::size_t>(boxes * boxes * boxes))
{
  Dice dice(seed ^ 0xd1271U);
  cavity_ = dice.uniform(0.0, 1.0) < 0.5 ? air : fluidHu;
  for (double at = 0.0; at < course.length(); at += 0.1) {
    const electrode::Section section = array.sectionAt(millimeters(at));
    // The way to the opening widens like a cone; the window itself is closed with tissue.
    const double out = at - course.opening - 0.8;
    addBall({course.at(at), 0.25 * (inMillimeters(section.across) + inMillimeters(section.within)),
             out > 0.0 ? std::min(2.5, 0.8 + 0.4 * out) : 0.0});
  }
  metal_ = wiresOf(array, course);
  for (std::size_t i = 0; i < array.contactsFromTip.size(); ++i) {
    const auto plate = platinumOf(array, course, i);
    metal_.insert(metal_.end(), plate.begin(), plate.end());
  }
  addLead(array, course);
  if (hasOldLead) addOldLead(course, dice);
}

void ImplantSurroundings::addWires(const std::vector<Eigen::Vector3d>& points, double number)
{
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector3d step = points[i] - points[i - 1];
    constexpr int pieces = 5;
    for (int k = 0; k < pieces; ++k)
      metal_.push_back({points[i - 1] + (k + 0.5) / pieces * step,
                        number * wireArea_mm2 * step.norm() / pieces, false});
  }
}

void ImplantSurroundings::addLead(const electrode::ArrayDesign& array, const Course& course)
{
  // From the array's end on, bending by a radius of 25 mm.
  constexpr double bend_mm = 25.0;
  const Eigen::Vector3d end = course.at(course.length()), away = -course.tangent(course.length());
  const Eigen::Vector3d side = away.unitOrthogonal();
  for (double at = 0.0; at < 25.0; at += 0.1) {
    lead_.emplace_back(end + at * away + 0.5 * at * at / bend_mm * side);
    addBall({lead_.back(), leadRadius_mm, 2.5});
  }
  addWires(lead_, static_cast<double>(array.contactsFromTip.size()));
}

void ImplantSurroundings::addOldLead(const Course& course, Dice& dice)
{
  constexpr double number = 16.0;
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Eigen::Vector3d along =
        Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal()).normalized();
    const Eigen::Vector3d beside = along.unitOrthogonal();
    const Eigen::Vector3d out = Eigen::AngleAxisd(dice.uniform(0.0, 2.0 * pi), along) * beside;
    old_.clear();
    for (double at = -16.0; at < 16.0; at += 0.1)
      old_.emplace_back(middle_W + 7.5 * out + at * along + 0.02 * at * at * out.cross(along));
    double nearest = 1e9;
    for (const Eigen::Vector3d& point : old_) {
      nearest = std::min(nearest, -ear_.inside(point));
      for (double at = 0.0; at < course.length(); at += 0.5)
        nearest = std::min(nearest, (course.at(at) - point).norm());
    }
    if (nearest > 1.5) break;
  }
  for (const Eigen::Vector3d& point : old_) addBall({point, leadRadius_mm, 1.0});
  addWires(old_, number);
}

std::size_t ImplantSurroundings::boxOf(const Eigen::Vector3d& point) const
{
  std::size_t index = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const int at = std::clamp(
        static_cast<int>((point[axis] - middle_W[axis] + halfWidth_mm) / box_mm), 0, boxes - 1);
    index = index * boxes + static_cast<std::size_t>(at);
  }
  return index;
}

void ImplantSurroundings::addBall(const Ball& ball)
{
  const double reach = std::max(ball.silicone, ball.drilled) + 0.3;
  const int around = static_cast<int>(std::ceil(reach / box_mm));
  const int number = static_cast<int>(balls_.size());
  balls_.push_back(ball);
  for (int c = -around; c <= around; ++c)
    for (int b = -around; b <= around; ++b)
      for (int a = -around; a <= around; ++a) {
        const Eigen::Vector3d at = ball.center + box_mm * Eigen::Vector3d(a, b, c);
        if (((at - middle_W).cwiseAbs().array() > halfWidth_mm).any()) continue;
        near_[boxOf(at)].push_back(number);
      }
}

double ImplantSurroundings::intensity(const Eigen::Vector3d& p, double cell) const
{
  double value = ear_.intensity(p, cell);
  if (((p - middle_W).cwiseAbs().array() > halfWidth_mm).any()) return value;
  double inDrilled = -1.0, inSilicone = -1.0;
  for (const int number : near_[boxOf(p)]) {
    const Ball& ball = balls_[static_cast<std::size_t>(number)];
    const double distance = (p - ball.center).norm();
    if (ball.drilled > 0.0) inDrilled = std::max(inDrilled, ball.drilled - distance);
    inSilicone = std::max(inSilicone, ball.silicone - distance);
  }
  // The labyrinth is not drilled.
  if (inDrilled > -cell) {
    const double outside = part(-ear_.inside(p) - 0.3, cell);
    value += part(inDrilled, cell) * outside * (cavity_ - value);
  }
  value += part(inSilicone, cell) * (silicone - value);
  return value;
}

}  // namespace perilymph::test
