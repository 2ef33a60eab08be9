// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

namespace perilymph::visualization {
namespace {

double lengthOf(const Polyline& line)
{
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

bool crosses(double a, double b) { return (a < 0.0) != (b < 0.0); }

}  // namespace

std::vector<Eigen::Vector3d> pointNormals(const std::vector<Eigen::Vector3d>& points,
                                          const std::vector<Triangle>& triangles)
{
  std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d::Zero());
  for (const Triangle& corners : triangles) {
    const auto corner = [&](int i) {
      return points[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
    };
    const Eigen::Vector3d area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (const int index : corners) normals[static_cast<std::size_t>(index)] += area;
  }
  for (Eigen::Vector3d& normal : normals) {
    const double length = normal.norm();
    normal = length > 0.0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d(0.0, 0.0, 1.0);
  }
  return normals;
}

Silhouette::Silhouette(std::vector<Eigen::Vector3d> points, std::vector<Eigen::Vector3d> normals,
                       std::vector<Triangle> triangles)
    : points_(std::move(points)), normals_(std::move(normals)), triangles_(std::move(triangles))
{
  std::map<std::pair<int, int>, int> known;
  edgesOf_.resize(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangles_[t][k];
      const int b = triangles_[t][(k + 1) % 3];
      const auto [place, isNew] =
          known.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(edges_.size()));
      if (isNew) edges_.push_back({a, b, {-1, -1}});
      Edge& edge = edges_[static_cast<std::size_t>(place->second)];
      edge.triangle[edge.triangle[0] < 0 ? 0 : 1] = static_cast<int>(t);
      edgesOf_[t][k] = place->second;
    }
}

Eigen::Vector3d Silhouette::crossing(int edge, const std::vector<double>& facing) const
{
  const Edge& e = edges_[static_cast<std::size_t>(edge)];
  const std::size_t from = static_cast<std::size_t>(e.from);
  const std::size_t to = static_cast<std::size_t>(e.to);
  const double fraction = facing[from] / (facing[from] - facing[to]);
  return points_[from] + fraction * (points_[to] - points_[from]);
}

void Silhouette::walk(int triangle, int edge, const std::vector<double>& facing,
                      std::vector<unsigned char>& isDone, Polyline& line) const
{
  // Leave each triangle by its other intersected edge until the surface or the line ends.
  while (triangle >= 0 && isDone[static_cast<std::size_t>(triangle)] == 0) {
    isDone[static_cast<std::size_t>(triangle)] = 1;
    int next = -1;
    for (const int candidate : edgesOf_[static_cast<std::size_t>(triangle)]) {
      const Edge& e = edges_[static_cast<std::size_t>(candidate)];
      if (candidate != edge &&
          crosses(facing[static_cast<std::size_t>(e.from)], facing[static_cast<std::size_t>(e.to)]))
        next = candidate;
    }
    if (next < 0) return;
    line.push_back(crossing(next, facing));
    const Edge& e = edges_[static_cast<std::size_t>(next)];
    triangle = e.triangle[0] == triangle ? e.triangle[1] : e.triangle[0];
    edge = next;
  }
}

std::vector<Polyline> Silhouette::lines(const Eigen::Vector3d& back, double shortest_mm) const
{
  std::vector<double> facing(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    facing[i] = normals_[i].dot(back);
    if (facing[i] == 0.0) facing[i] = 1e-12;  // no intersection exactly at a point
  }

  std::vector<Polyline> found;
  std::vector<unsigned char> isDone(triangles_.size(), 0);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (isDone[t] != 0) continue;
    for (const int start : edgesOf_[t]) {
      const Edge& e = edges_[static_cast<std::size_t>(start)];
      if (!crosses(facing[static_cast<std::size_t>(e.from)],
                   facing[static_cast<std::size_t>(e.to)]))
        continue;
      Polyline line, backward;
      line.push_back(crossing(start, facing));
      walk(static_cast<int>(t), start, facing, isDone, line);
      const int other = e.triangle[0] == static_cast<int>(t) ? e.triangle[1] : e.triangle[0];
      walk(other, start, facing, isDone, backward);
      std::reverse(backward.begin(), backward.end());
      backward.insert(backward.end(), line.begin(), line.end());
      if (lengthOf(backward) >= shortest_mm) found.push_back(std::move(backward));
      break;
    }
  }
  return found;
}

std::vector<Polyline> Silhouette::rims() const
{
  std::map<int, std::vector<int>> neighbors;
  for (const Edge& edge : edges_)
    if (edge.triangle[1] < 0) {
      neighbors[edge.from].push_back(edge.to);
      neighbors[edge.to].push_back(edge.from);
    }
  std::vector<Polyline> found;
  std::map<int, bool> isDone;
  for (const auto& [start, unused] : neighbors) {
    if (isDone[start]) continue;
    Polyline line;
    int at = start;
    while (at >= 0) {
      isDone[at] = true;
      line.push_back(points_[static_cast<std::size_t>(at)]);
      int next = -1;
      for (const int candidate : neighbors[at])
        if (!isDone[candidate]) next = candidate;
      at = next;
    }
    line.push_back(line.front());
    found.push_back(std::move(line));
  }
  return found;
}

}  // namespace perilymph::visualization
