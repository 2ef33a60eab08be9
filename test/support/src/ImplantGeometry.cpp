// SPDX-License-Identifier: BSD-3-Clause
#include "ImplantGeometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "lumen/OutlineTables.h"
#include "perilymph/analysis/ExperimentDevice.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/Scenario.h"
#include "sources/MeanOutlines.h"

namespace perilymph::test {
namespace {

double smoothStep(double x)
{
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// The part of a kidney below the partition, in m. The lamina ends a tenth inward of the middle.
anatomy::Outline lowerOutline(const KidneySection& section, double partition)
{
  constexpr int pieces = 48;
  const double edge = std::acos(-partition);  // where the partition meets the wall
  anatomy::Outline outline;
  const auto add = [&](double u, double v, double bent) {
    outline.push_back({1e-3 * (section.middleRadius + u),
                       1e-3 * (section.middleHeight + v + section.shear * u + bent)});
  };
  // The floor from the inner to the outer wall, then back below the partition: counter-clockwise.
  for (int i = 0; i <= pieces; ++i) {
    const double t = edge * (2.0 * i / pieces - 1.0);
    const double semi = t > 0.0 ? section.outward : section.inward;
    const double u = semi * std::sin(t);
    add(u, -section.half * std::cos(t), section.bend * u * u);
  }
  const double side = std::sin(edge);
  for (int i = 1; i < pieces; ++i) {
    const double u = side * (section.outward - (section.outward + section.inward) * i / pieces);
    const double lamina = PhantomAnatomy::laminaHalf_mm * std::min(1.0, section.half / 0.5) *
                          smoothStep((0.1 * section.outward - u) / (0.3 * section.inward)) *
                          smoothStep((u + side * section.inward) / (0.2 * section.inward));
    const double bent =
        section.bend * u * u *
        std::pow(std::abs(u) / (side * (u > 0.0 ? section.outward : section.inward)), 2);
    add(u, partition * section.half - lamina, bent);
  }
  return outline;
}

/// A course through points, by equal steps of its length: Catmull-Rom between them.
std::vector<Eigen::Vector3d> byLength(const std::vector<Eigen::Vector3d>& knots, double length)
{
  std::vector<Eigen::Vector3d> fine;
  constexpr int pieces = 32;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Eigen::Vector3d &b = knots[i], &c = knots[i + 1];
    const Eigen::Vector3d a = i > 0 ? knots[i - 1] : Eigen::Vector3d(2.0 * b - c);
    const Eigen::Vector3d d = i + 2 < knots.size() ? knots[i + 2] : Eigen::Vector3d(2.0 * c - b);
    for (int k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      fine.emplace_back(0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                               (3.0 * b - a - 3.0 * c + d) * t * t * t));
    }
  }
  fine.push_back(knots.back());
  std::vector<Eigen::Vector3d> even{fine.front()};
  double passed = 0.0, next = Course::step;
  for (std::size_t i = 1; i < fine.size() && next <= length + 1e-9; ++i) {
    const double piece = (fine[i] - fine[i - 1]).norm();
    for (; next <= passed + piece && next <= length + 1e-9; next += Course::step)
      even.emplace_back(fine[i - 1] + (next - passed) / piece * (fine[i] - fine[i - 1]));
    passed += piece;
  }
  // An array is a little longer than the chords between its nodes: its end goes straight on.
  const Eigen::Vector3d on = (fine.back() - fine[fine.size() - 2]).normalized();
  for (; next <= length + 1e-9; next += Course::step)
    even.emplace_back(fine.back() + (next - passed) * on);
  return even;
}

/// Nodes of an array as the engine inserts it, the tip first.
struct Inserted {
  std::vector<Eigen::Vector3d> nodes_W;
};

double intendedDepth_mm(const electrode::ArrayDesign& array, const ImplantCondition& condition)
{
  const double greatest = inMillimeters(array.insertable);
  double depth = greatest * std::clamp(condition.insertedFraction, 0.15, 1.0);
  const auto& contacts = array.contactsFromTip;
  const auto outside = static_cast<std::size_t>(condition.contactsOutside);
  if (outside > 0 && outside < contacts.size()) {
    const std::size_t first = contacts.size() - outside;
    depth = std::min(depth, inMillimeters(0.5 * (contacts[first] + contacts[first - 1])));
  }
  return depth;
}

/// A surgeon who pushes to the intended depth, whatever is felt: the partition does not rupture.
Inserted insert(std::shared_ptr<const anatomy::ScalaTympani> scala,
                const ImplantCondition& condition, std::uint64_t seed)
{
  session::Overrides changes{{"array", condition.array},
                             {"stop_travel_mm", session::anyStopTravel},
                             {"nodes", "100"},
                             {"dt_ms", "5"}};
  auto scenario = session::loadScenario("surgery-flex28", changes);
  if (scenario && scenario->array().hasStylet && scenario->array().stylet.holdDepth) {
    changes.emplace_back("technique", "aos");
    scenario = session::loadScenario("surgery-flex28", changes);
  }
  if (!scenario) throw std::runtime_error(scenario.error().message);
  session::InsertionParameters parameters = scenario->parameters();
  Dice dice(seed ^ 0x1459aU);
  const double depth = intendedDepth_mm(parameters.array, condition);
  parameters.speed = millimetersPerSecond(1.5);
  parameters.friction = parameters.friction.scaled(dice.uniform(0.3, 0.9));
  parameters.approachTilt = degrees(4.0 * std::clamp(dice.normal(), -2.0, 2.0));
  parameters.approachTurn = degrees(4.0 * std::clamp(dice.normal(), -2.0, 2.0));
  parameters.stopTravel = millimeters(depth + 1.0) - parameters.startInside;
  parameters.engine.stopTravel = parameters.stopTravel.si();
  parameters.engine.samplePeriod = parameters.timeStep.si();
  const auto forceps = std::make_shared<analysis::ExperimentDevice>(
      analysis::TremblingPush{.speed = parameters.speed.si()}, parameters.timeStep);
  auto insertion = session::Insertion::prepare(parameters, forceps, std::move(scala));
  if (!insertion) throw std::runtime_error(insertion.error().message);
  const double step = parameters.timeStep.si();
  const auto push = [&](const haptics::TickRecord& record) {
    return record.output.depth < 1e-3 * depth;
  };
  auto ran =
      (*insertion)
          ->runToEnd(push, static_cast<std::uint64_t>(
                               (parameters.stopTravel.si() / parameters.speed.si() + 1.0) / step));
  forceps->rest();
  if (ran && parameters.array.hasStylet) {
    haptics::Command pull;
    pull.kind = haptics::Command::Kind::pullStylet;
    pull.value = parameters.array.length.si();
    if ((*insertion)->send(pull))
      ran = (*insertion)
                ->runToEnd([](const haptics::TickRecord&) { return true; },
                           static_cast<std::uint64_t>(
                               (pull.value / parameters.styletSpeed.si() + 0.5) / step));
  }
  if (!ran) throw std::runtime_error(ran.error().message);
  (*insertion)->refresh();
  const haptics::Snapshot& now = (*insertion)->latest();
  Inserted inserted;
  for (std::uint32_t i = now.nodes; i-- > 0;)
    inserted.nodes_W.emplace_back(
        1e3 * Eigen::Vector3d(now.node_W[i][0], now.node_W[i][1], now.node_W[i][2]));
  if (inserted.nodes_W.size() < 2) throw std::runtime_error("The array was not inserted.");
  return inserted;
}

/// Angles continued along a course from its end outside, and where it passes the plane of the round window.
void measureAngles(Course& course)
{
  const std::size_t count = course.points_W.size();
  course.angles.assign(count, 0.0);
  const auto angleOf = [](const Eigen::Vector3d& p) { return std::atan2(p.y(), p.x()); };
  double angle = angleOf(course.points_W.back());
  course.opening = 0.0;
  bool isInside = false;
  for (std::size_t i = count; i-- > 0;) {
    angle += std::remainder(angleOf(course.points_W[i]) - angle, 2.0 * pi);
    course.angles[i] = angle;
    if (!isInside && angle >= 0.0) {
      isInside = true;
      course.opening = Course::step * static_cast<double>(i);
    }
  }
}

/// The course through the nodes of an inserted array.
Course courseThrough(Inserted inserted, const electrode::ArrayDesign& array)
{
  Course course;
  const double length = std::floor(inMillimeters(array.length) / Course::step + 0.5) * Course::step;
  // From the base, so that what is rounded is at the tip.
  std::reverse(inserted.nodes_W.begin(), inserted.nodes_W.end());
  course.points_W = byLength(inserted.nodes_W, length);
  std::reverse(course.points_W.begin(), course.points_W.end());
  measureAngles(course);
  return course;
}

/// The tip doubled back: a half circle of radius `bend` toward the side with more room, then along the course.
void fold(Course& course, const PhantomAnatomy& anatomy, Dice& dice)
{
  const double length = course.length();
  const double doubled = std::min(dice.uniform(4.0, 6.0), 0.45 * course.opening);
  const double bend = dice.uniform(0.3, 0.36);  // half the distance of both legs [mm]
  const auto inward = [&](double at) -> Eigen::Vector3d {
    const Eigen::Vector3d point = course.at(at), along = course.tangent(at);
    const Eigen::Vector3d radial(-point.x(), -point.y(), 0.0);
    return (radial - radial.dot(along) * along).normalized();
  };
  double room = 0.0;
  for (const double ahead : {0.0, 1.0, 2.0, 3.0}) {
    const double at = doubled + ahead;
    room += anatomy.inside(course.at(at) + 2.0 * bend * inward(at)) -
            anatomy.inside(course.at(at) - 2.0 * bend * inward(at));
  }
  const double side = room > 0.0 ? 1.0 : -1.0;
  std::vector<Eigen::Vector3d> knots;  // from the base
  for (double at = length; at > doubled; at -= 0.1) knots.push_back(course.at(at));
  const Eigen::Vector3d turn = course.at(doubled), ahead = course.tangent(doubled);
  for (double t = 0.0; t < pi; t += 0.15)
    knots.emplace_back(turn +
                       bend * (std::sin(t) * ahead + side * (1.0 - std::cos(t)) * inward(doubled)));
  for (double at = doubled + 0.05; at < doubled + 8.0; at += 0.1)
    knots.emplace_back(course.at(at) + side * 2.0 * bend * inward(at));
  std::vector<Eigen::Vector3d> even = byLength(knots, length);
  std::reverse(even.begin(), even.end());
  course.points_W = std::move(even);
  course.fold = doubled - 0.5 * pi * bend;
}

/// The part beyond an angle lifted into the upper scala within 1 to 2 mm of the array.
void translocate(Course& course, const PhantomAnatomy& anatomy, double from, Dice& dice)
{
  const double length = course.length();
  const double within = dice.uniform(1.0, 2.0);
  double start = -1.0;
  for (double at = course.opening; at >= 0.0; at -= Course::step)
    if (course.angleAt(at) >= from) {
      start = at + 0.5 * within;
      break;
    }
  if (start < 0.0)
    throw std::runtime_error("The array does not reach the angle of the translocation.");
  std::vector<Eigen::Vector3d> knots;
  for (double at = length; at >= 0.0; at -= 0.1) {
    Eigen::Vector3d point = course.at(at);
    if (at < start) {
      const KidneySection section = anatomy.sectionAt(course.angleAt(at));
      const double u = point.head<2>().norm() - section.middleRadius;
      const double floor = section.middleHeight + section.shear * u;
      const double partition = anatomy.laminaAt(course.angleAt(at));
      // To 0.4 of the half height, less where the wall is near.
      const double semi = u > 0.0 ? section.outward : section.inward;
      const double room = std::sqrt(std::max(0.0, 1.0 - u * u / (semi * semi)));
      const double wanted = floor + section.half * (partition + 0.55 * (room - partition));
      point.z() += smoothStep((start - at) / within) * std::max(0.0, wanted - point.z());
    }
    knots.push_back(point);
  }
  std::vector<Eigen::Vector3d> even = byLength(knots, length);
  std::reverse(even.begin(), even.end());
  course.points_W = std::move(even);
}

}  // namespace

std::shared_ptr<const anatomy::ScalaTympani> lowerScala(const PhantomAnatomy& anatomy)
{
  const double last = anatomy.lastAngle() - degrees(4).si();
  const anatomy::OutlineSource source = [&](double angle) {
    const KidneySection section = anatomy.sectionAt(angle);
    const double end = std::min(1.0, section.half / 0.4);
    const double width =
        std::min(anatomy::membraneWidth(angle, last) * end, 0.35e-3 * section.outward);
    return anatomy::OutlineAtAngle{lowerOutline(section, anatomy.laminaAt(angle)),
                                   1e-3 * section.middleRadius, width};
  };
  auto scala = std::make_shared<const anatomy::ScalaTympani>(
      anatomy::tablesFrom(source, "phantom", last, 0.0));
  return scala;
}

bool isAbovePartition(const PhantomAnatomy& anatomy, const Eigen::Vector3d& p, double angle)
{
  const KidneySection section = anatomy.sectionAt(angle);
  const double u = p.head<2>().norm() - section.middleRadius;
  return p.z() - section.middleHeight - section.shear * u > anatomy.laminaAt(angle) * section.half;
}

Eigen::Vector3d Course::at(double fromTip) const
{
  const double x = std::clamp(fromTip / step, 0.0, static_cast<double>(points_W.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(x), points_W.size() - 2);
  const double t = x - static_cast<double>(i);
  return points_W[i] + t * (points_W[i + 1] - points_W[i]);
}

Eigen::Vector3d Course::tangent(double fromTip) const
{
  const double reach = 0.1;
  return (at(fromTip - reach) - at(fromTip + reach)).normalized();
}

double Course::angleAt(double fromTip) const
{
  const double x = std::clamp(fromTip / step, 0.0, static_cast<double>(points_W.size() - 1));
  return angles[static_cast<std::size_t>(std::lround(x))];
}

electrode::ArrayDesign shippedArray(const std::string& name)
{
  const auto scenario = session::loadScenario(
      "surgery-flex28", {{"array", name}, {"stop_travel_mm", session::anyStopTravel}});
  if (!scenario) throw std::runtime_error(scenario.error().message);
  return scenario->array();
}

Course insertedCourse(std::uint64_t seed, const PhantomAnatomy& anatomy,
                      const electrode::ArrayDesign& array, const ImplantCondition& condition)
{
  using Key = std::tuple<std::uint64_t, std::string, double, int>;
  static std::mutex mutex;
  static std::map<Key, Inserted> kept;
  Inserted inserted;
  {
    const std::lock_guard lock(mutex);
    const Key key{seed, condition.array, condition.insertedFraction, condition.contactsOutside};
    auto found = kept.find(key);
    if (found == kept.end())
      found = kept.emplace(key, insert(lowerScala(anatomy), condition, seed)).first;
    inserted = found->second;
  }
  Course course = courseThrough(std::move(inserted), array);
  Dice dice(seed ^ 0xf01dU);
  if (condition.translocationAngle_deg) {
    translocate(course, anatomy, degrees(*condition.translocationAngle_deg).si(), dice);
    measureAngles(course);
  }
  if (condition.isFolded) {
    fold(course, anatomy, dice);
    measureAngles(course);
  }
  return course;
}

Course insertedCourse(std::uint64_t seed, std::shared_ptr<const anatomy::ScalaTympani> scala,
                      const electrode::ArrayDesign& array, const ImplantCondition& condition)
{
  return courseThrough(insert(std::move(scala), condition, seed), array);
}

std::vector<MetalPiece> platinumOf(const electrode::ArrayDesign& array, const Course& course,
                                   std::size_t contact)
{
  // Width around the carrier and thickness of a plate: choices, confidence low.
  constexpr double plateWidth_mm = 0.5, thickness_mm = 0.035, cell_mm = 0.02;
  const double middle = inMillimeters(array.contactsFromTip[contact]);
  const double length = inMillimeters(array.contactLength);
  const electrode::Plates plates = array.platesOf(contact);
  std::vector<MetalPiece> pieces;
  const int along = std::max(1, static_cast<int>(std::lround(length / cell_mm)));
  for (int i = 0; i < along; ++i) {
    const double at = middle + length * ((i + 0.5) / along - 0.5);
    const electrode::Section section = array.sectionAt(millimeters(at));
    const double radius =
        0.25 * (inMillimeters(section.across) + inMillimeters(section.within)) - 0.5 * thickness_mm;
    const Eigen::Vector3d point = course.at(at), tangent = course.tangent(at);
    Eigen::Vector3d inward(-point.x(), -point.y(), 0.0);
    inward = (inward - inward.dot(tangent) * tangent).normalized();
    const Eigen::Vector3d up = tangent.cross(inward);
    const auto addPlate = [&](double toward, double halfAngle) {
      const int around =
          std::max(1, static_cast<int>(std::lround(2.0 * halfAngle * radius / cell_mm)));
      for (int k = 0; k < around; ++k) {
        const double t = toward + halfAngle * (2.0 * (k + 0.5) / around - 1.0);
        pieces.push_back({point + radius * (std::cos(t) * inward + std::sin(t) * up),
                          length / along * 2.0 * halfAngle * radius / around * thickness_mm, true});
      }
    };
    const double half = std::min(0.5 * plateWidth_mm / radius, 0.45 * pi);
    if (plates == electrode::Plates::band)
      addPlate(0.0, pi);
    else
      addPlate(plates == electrode::Plates::pair ? 0.5 * pi : 0.0, half);
    if (plates == electrode::Plates::pair) addPlate(-0.5 * pi, half);
  }
  return pieces;
}

std::vector<MetalPiece> wiresOf(const electrode::ArrayDesign& array, const Course& course)
{
  // Insulated wires of 25 um, as the arrays' files estimate them; one for each contact nearer to the tip.
  constexpr double area_mm2 = 0.25 * pi * 0.025 * 0.025;
  constexpr double bundle_mm = 0.06;  // radius of the bundle: choice, low
  std::vector<MetalPiece> pieces;
  for (double at = inMillimeters(array.contactsFromTip.front()); at < course.length();
       at += Course::step) {
    double number = 0.0;
    for (const Length contact : array.contactsFromTip)
      number += inMillimeters(contact) <= at ? 1.0 : 0.0;
    const Eigen::Vector3d point = course.at(at), tangent = course.tangent(at);
    const Eigen::Vector3d side = tangent.unitOrthogonal(), other = tangent.cross(side);
    for (int k = 0; k < 4; ++k) {
      const double t = 0.5 * pi * k + at;
      pieces.push_back({point + bundle_mm * (std::cos(t) * side + std::sin(t) * other),
                        0.25 * number * area_mm2 * Course::step, false});
    }
  }
  return pieces;
}

}  // namespace perilymph::test
