// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceSolid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace perilymph::test {
namespace {

constexpr const char* variable = "PERILYMPH_REFERENCE_DATA";
constexpr double cell = 0.2e-3;  // [m]

// Modiolar axis and first section in the frame of the solid's file.
constexpr double axisX_mm = -2.6908784177817076;
constexpr double axisY_mm = 3.8483421030346103;
constexpr double firstSection_deg = -63.587630278876766;

std::filesystem::path solidFile()
{
  const char* folder = std::getenv(variable);
  return folder ? std::filesystem::path(folder) / "st_mean_2024" / "st_mean_model_mm.stl"
                : std::filesystem::path();
}

/// Distance from a point to a triangle (Ericson, Real-Time Collision Detection, section 5.1.5).
double distanceTo(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& p)
{
  const Eigen::Vector3d ab = triangle[1] - triangle[0];
  const Eigen::Vector3d ac = triangle[2] - triangle[0];
  const Eigen::Vector3d normal = ab.cross(ac);
  const Eigen::Vector3d ap = p - triangle[0];
  const double size = normal.squaredNorm();
  if (size > 0.0) {
    const double v = ap.cross(ac).dot(normal) / size;
    const double w = ab.cross(ap).dot(normal) / size;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return std::fabs(ap.dot(normal)) / std::sqrt(size);
  }
  double nearest = 1e9;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& a = triangle[k];
    const Eigen::Vector3d edge = triangle[(k + 1) % 3] - a;
    const double length = edge.squaredNorm();
    const double fraction = length > 0.0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + fraction * edge - p).norm());
  }
  return nearest;
}

}  // namespace

bool ReferenceSolid::isThere() { return std::filesystem::is_regular_file(solidFile()); }

std::string ReferenceSolid::whyNot()
{
  return std::string(variable) +
         " names no folder with st_mean_2024/st_mean_model_mm.stl; the solid is not shipped.";
}

ReferenceSolid::ReferenceSolid()
{
  std::ifstream file(solidFile(), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  std::uint32_t count = 0;
  if (bytes.size() >= 84) std::memcpy(&count, bytes.data() + 80, 4);
  if (count == 0 || bytes.size() < 84 + 50 * static_cast<std::size_t>(count))
    throw std::runtime_error("The reference solid is not a binary STL.");

  const double turn = firstSection_deg * std::acos(-1.0) / 180.0;
  std::map<std::array<float, 3>, bool> seen;
  for (std::size_t i = 0; i < count; ++i) {
    float numbers[12];
    std::memcpy(numbers, bytes.data() + 84 + 50 * i, sizeof numbers);
    std::array<Eigen::Vector3d, 3> triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const float* corner = numbers + 3 + 3 * k;
      const double x = corner[0] - axisX_mm;
      const double y = corner[1] - axisY_mm;
      triangle[k] = Eigen::Vector3d(x * std::cos(turn) + y * std::sin(turn),
                                    y * std::cos(turn) - x * std::sin(turn), corner[2]) /
                    1e3;
      if (seen.emplace(std::array<float, 3>{corner[0], corner[1], corner[2]}, true).second)
        points_.push_back(triangle[k]);
    }
    Eigen::Vector3d low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
    Eigen::Vector3d high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
    const Cell from = cellOf(low), to = cellOf(high);
    for (long a = from[0]; a <= to[0]; ++a)
      for (long b = from[1]; b <= to[1]; ++b)
        for (long c = from[2]; c <= to[2]; ++c) cells_[{a, b, c}].push_back(i);
    triangles_.push_back(triangle);
  }
}

ReferenceSolid::Cell ReferenceSolid::cellOf(const Eigen::Vector3d& point)
{
  return {std::lround(std::floor(point.x() / cell)), std::lround(std::floor(point.y() / cell)),
          std::lround(std::floor(point.z() / cell))};
}

double ReferenceSolid::distance(const Eigen::Vector3d& point) const
{
  const Cell here = cellOf(point);
  double nearest = 1.0;
  for (long a = -2; a <= 2; ++a)
    for (long b = -2; b <= 2; ++b)
      for (long c = -2; c <= 2; ++c) {
        const auto found = cells_.find({here[0] + a, here[1] + b, here[2] + c});
        if (found == cells_.end()) continue;
        for (const std::size_t i : found->second)
          nearest = std::min(nearest, distanceTo(triangles_[i], point));
      }
  return nearest;
}

}  // namespace perilymph::test
