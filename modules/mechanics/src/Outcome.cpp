// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/Outcome.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "perilymph/foundation/Math.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

/// A point between two nodes of the array.
struct Place {
  std::size_t node;  ///< The one nearer to the tweezers.
  double fraction;   ///< Fraction of the way to the next node.
};

Place placeOf(const electrode::ArrayDesign& array, std::size_t nodes, double fromTip)
{
  const double spacing = array.length.si() / static_cast<double>(nodes - 1);
  const double index = (array.length.si() - fromTip) / spacing;
  const double last = static_cast<double>(nodes - 2);
  const double node = std::clamp(std::floor(index), 0.0, last);
  return {static_cast<std::size_t>(node), std::clamp(index - node, 0.0, 1.0)};
}

/// Direction of curl at each node, transported without twist.
std::vector<Vector3d> carried(const ArrayShape& shape)
{
  std::vector<Vector3d> curl(shape.nodes_W.size());
  Vector3d p = (shape.nodes_W[1] - shape.nodes_W[0]).normalized();
  Vector3d d = (shape.baseCurl_W - shape.baseCurl_W.dot(p) * p).normalized();
  curl[0] = d;
  for (std::size_t i = 1; i + 1 < curl.size(); ++i) {
    const Vector3d t = (shape.nodes_W[i + 1] - shape.nodes_W[i]).normalized();
    const Vector3d next = d - (d.dot(t) / std::max(1.0 + p.dot(t), 1e-3)) * (p + t);
    curl[i] = (d + next).normalized();
    d = next;
    p = t;
  }
  curl.back() = d;
  return curl;
}

anatomy::WallPoint wallAt(const anatomy::Lumen& lumen, const Vector3d& at,
                          anatomy::LumenTrack& track, double reach)
{
  anatomy::WallPoint wall;
  lumen.nearestWall({&at, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  return wall;
}

/// Distance to the opposite wall in a direction, by sphere tracing. From a point beyond a wall, the
/// lumen may begin a short distance ahead. Negative if there is none.
double distanceAlong(const anatomy::Lumen& lumen, const Vector3d& from, const Vector3d& direction,
                     anatomy::LumenTrack track)
{
  constexpr double farthest = 10e-3;  // [m]
  constexpr double deepest = 0.5e-3;  // maximum depth of an array pressed beyond a wall [m]
  constexpr double onWall = 0.1e-6;   // [m]
  double gone = 0.0;
  bool isInside = false;
  for (int i = 0; i < 400 && gone < farthest; ++i) {
    const anatomy::WallPoint wall = wallAt(lumen, from + gone * direction, track, 3e-3);
    const double step = wall.isNear ? wall.distance : 0.2e-3;
    if (step >= onWall) {
      isInside = true;
      gone += 0.9 * step;
    } else if (isInside) {
      return gone;
    } else {
      if (gone > deepest) return -1.0;
      gone += 2.0 * onWall - step;
    }
  }
  return -1.0;
}

}  // namespace

std::vector<ContactOutcome> outcomeOf(const InsertionModel& model, const ArrayShape& shape)
{
  if (shape.nodes_W.size() != static_cast<std::size_t>(model.nodes))
    throw std::invalid_argument("The shape has " + std::to_string(shape.nodes_W.size()) +
                                " nodes; the model has " + std::to_string(model.nodes) + ".");
  return outcomeOf(*model.parts.lumen, model.parts.array, shape);
}

std::vector<ContactOutcome> outcomeOf(const anatomy::Lumen& lumen,
                                      const electrode::ArrayDesign& array, const ArrayShape& shape)
{
  if (shape.nodes_W.size() < 2)
    throw std::invalid_argument("The shape has " + std::to_string(shape.nodes_W.size()) +
                                " nodes; an array has 2 or more.");
  const anatomy::Entry entry = lumen.entry();

  // the turn of each node, tracked along the array from the opening
  std::vector<anatomy::LumenTrack> track(shape.nodes_W.size(), lumen.startTrack());
  for (std::size_t i = 0; i < track.size(); ++i) {
    if (i > 0) track[i] = track[i - 1];
    wallAt(lumen, shape.nodes_W[i], track[i], 3e-3);
  }
  const std::vector<Vector3d> curl =
      shape.curl_W.size() == shape.nodes_W.size()
          ? std::vector<Vector3d>(shape.curl_W.begin(), shape.curl_W.end())
          : carried(shape);

  std::vector<ContactOutcome> outcome;
  for (const Length& contact : array.contactsFromTip) {
    ContactOutcome o;
    o.fromTip = contact.si();
    const Place place = placeOf(array, shape.nodes_W.size(), o.fromTip);
    const Vector3d edge = shape.nodes_W[place.node + 1] - shape.nodes_W[place.node];
    o.position_W = shape.nodes_W[place.node] + place.fraction * edge;
    o.isInside = anatomy::behindOpening(entry, o.position_W, track[place.node]) > 0.0;
    if (o.isInside) {
      anatomy::LumenTrack here = track[place.node];
      wallAt(lumen, o.position_W, here, 3e-3);
      o.angle = here.angle;
      const Vector3d inward(-o.position_W.x(), -o.position_W.y(), 0.0);
      o.toModiolarAxis = inward.norm();
      if (o.toModiolarAxis > 0.0) {
        const Vector3d toAxis = inward / o.toModiolarAxis;
        o.toInnerWall = distanceAlong(lumen, o.position_W, toAxis, here);
        // both projected across the array
        const Vector3d t = edge.normalized();
        const Vector3d face =
            (1.0 - place.fraction) * curl[place.node] + place.fraction * curl[place.node + 1];
        const Vector3d a = face - face.dot(t) * t;
        const Vector3d b = toAxis - toAxis.dot(t) * t;
        o.offModiolus = arcTangent(a.cross(b).norm(), a.dot(b));
      }
    }
    outcome.push_back(o);
  }
  return outcome;
}

}  // namespace perilymph::mechanics
