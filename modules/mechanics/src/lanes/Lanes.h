// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Kernels of nodes, four at a time.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include "perilymph/foundation/Four.h"
#include "solver/Blocks.h"

namespace perilymph::mechanics {

using perilymph::Instructions;
using perilymph::kernelInstructions;
using perilymph::larger;
using perilymph::load;
using perilymph::machineInstructions;
using perilymph::oneOf;
using perilymph::smaller;
using perilymph::store;

/// One vector per node, axis by axis.
struct Axes {
  explicit Axes(std::size_t nodes = 0) : x(nodes), y(nodes), z(nodes) {}

  Eigen::Vector3d operator[](std::size_t i) const noexcept { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Eigen::Vector3d& v) noexcept
  {
    x[i] = v[0], y[i] = v[1], z[i] = v[2];
  }

  std::vector<double> x, y, z;
};

/// Calls a kernel for the nodes from `first` up to `end` by four: the last four overlap with those
/// before, so that no node is computed alone. A kernel may not read what it writes.
template <class Kernel>
PERILYMPH_IN_LANES void inLanes(std::size_t first, std::size_t end, const Kernel& kernel) noexcept
{
  withLanes([&]() PERILYMPH_KERNEL {
    if (first + 4 > end) {
      for (std::size_t i = first; i < end; ++i) kernel(double{}, i);
      return;
    }
    for (std::size_t i = first; i + 4 < end; i += 4) kernel(Four{}, i);
    kernel(Four{}, end - 4);
  });
}

/// The same for a kernel that changes what it reads at its own nodes: one by one for the last.
template <class Kernel>
PERILYMPH_IN_LANES void inLanesInPlace(std::size_t first, std::size_t end,
                                       const Kernel& kernel) noexcept
{
  withLanes([&]() PERILYMPH_KERNEL {
    std::size_t i = first;
    for (; i + 4 <= end; i += 4) kernel(Four{}, i);
    for (; i < end; ++i) kernel(double{}, i);
  });
}

template <class T>
PERILYMPH_IN_LANES T load(const std::vector<double>& from, std::size_t i) noexcept
{
  return load<T>(from.data(), i);
}

template <class T>
PERILYMPH_IN_LANES void store(const T& value, std::vector<double>& to, std::size_t i) noexcept
{
  store(value, to.data(), i);
}

/// The components of all vectors in a row, for what is the same along each axis.
inline const double* componentsOf(const std::vector<Eigen::Vector3d>& vectors) noexcept
{
  return vectors.data()->data();
}
inline double* componentsOf(std::vector<Eigen::Vector3d>& vectors) noexcept
{
  return vectors.data()->data();
}

template <class T>
PERILYMPH_IN_LANES Triple<T> load(const Axes& from, std::size_t i) noexcept
{
  return {load<T>(from.x, i), load<T>(from.y, i), load<T>(from.z, i)};
}

template <class T>
PERILYMPH_IN_LANES void store(const Triple<T>& v, Axes& to, std::size_t i) noexcept
{
  store(v.x, to.x, i);
  store(v.y, to.y, i);
  store(v.z, to.z, i);
}

/// Vectors that lie one after the other in memory, as x y z x | y z x y | z x y z.
template <class T>
PERILYMPH_IN_LANES Triple<T> load(const std::vector<Eigen::Vector3d>& from, std::size_t i) noexcept
{
  const double* at = componentsOf(from) + 3 * i;
  if constexpr (sizeof(T) == sizeof(double)) {
    return {at[0], at[1], at[2]};
  } else {
    Four a, b, c;
    std::memcpy(&a, at, sizeof a);
    std::memcpy(&b, at + 4, sizeof b);
    std::memcpy(&c, at + 8, sizeof c);
    const Four x = __builtin_shufflevector(a, b, 0, 3, 6, 6);
    const Four y = __builtin_shufflevector(a, b, 1, 4, 7, 7);
    const Four z = __builtin_shufflevector(a, b, 2, 5, 5, 5);
    return {__builtin_shufflevector(x, c, 0, 1, 2, 5), __builtin_shufflevector(y, c, 0, 1, 2, 6),
            __builtin_shufflevector(z, c, 0, 1, 4, 7)};
  }
}

template <class T>
PERILYMPH_IN_LANES void store(const Triple<T>& v, std::vector<Eigen::Vector3d>& to,
                              std::size_t i) noexcept
{
  double* at = componentsOf(to) + 3 * i;
  if constexpr (sizeof(T) == sizeof(double)) {
    at[0] = v.x, at[1] = v.y, at[2] = v.z;
  } else {
    const Four xy = __builtin_shufflevector(v.x, v.y, 0, 4, 1, 5);  // x0 y0 x1 y1
    const Four yx = __builtin_shufflevector(v.y, v.x, 1, 6, 2, 7);  // y1 x2 y2 x3
    const Four zx = __builtin_shufflevector(v.z, v.x, 0, 5, 1, 7);  // z0 x1 z1 x3
    const Four zy = __builtin_shufflevector(v.z, v.y, 2, 7, 3, 1);  // z2 y3 z3 .
    const Four a = __builtin_shufflevector(xy, zx, 0, 1, 4, 5);     // x0 y0 z0 x1
    const Four b = __builtin_shufflevector(yx, zx, 0, 6, 1, 2);     // y1 z1 x2 y2
    const Four c = __builtin_shufflevector(zy, v.x, 0, 7, 1, 2);    // z2 x3 y3 z3
    store(a, at, 0), store(b, at, 4), store(c, at, 8);
  }
}

/// Makes the vectors of one array those of another of the same size.
inline void copy(const std::vector<Eigen::Vector3d>& from,
                 std::vector<Eigen::Vector3d>& to) noexcept
{
  std::copy_n(componentsOf(from), 3 * from.size(), componentsOf(to));
}

PERILYMPH_IN_LANES double root(double a) noexcept { return std::sqrt(a); }
PERILYMPH_IN_LANES Four root(const Four& a) noexcept
{
  return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

PERILYMPH_IN_LANES double sumOf(const Four& a) noexcept { return (a[0] + a[1]) + (a[2] + a[3]); }

template <class T, class Condition>
PERILYMPH_IN_LANES Triple<T> oneOf(const Condition& condition, const Triple<T>& yes,
                                   const Triple<T>& no) noexcept
{
  return {oneOf(condition, yes.x, no.x), oneOf(condition, yes.y, no.y),
          oneOf(condition, yes.z, no.z)};
}

/// Joins the four lanes of a comparison: half with half, then the two that are left.
template <class Condition, class Join>
PERILYMPH_IN_LANES auto bothHalves(const Condition& condition, const Join& join) noexcept
{
  const auto two = join(__builtin_shufflevector(condition, condition, 0, 1),
                        __builtin_shufflevector(condition, condition, 2, 3));
  return join(two[0], two[1]);
}

/// Whether a comparison holds in every lane.
template <class Condition>
PERILYMPH_IN_LANES bool inAll(const Condition& condition) noexcept
{
  if constexpr (std::is_arithmetic_v<Condition>)
    return condition != 0;
  else
    return bothHalves(condition, [](const auto& a, const auto& b) { return a & b; }) != 0;
}

/// Whether a comparison holds in any lane.
template <class Condition>
PERILYMPH_IN_LANES bool inAny(const Condition& condition) noexcept
{
  if constexpr (std::is_arithmetic_v<Condition>)
    return condition != 0;
  else
    return bothHalves(condition, [](const auto& a, const auto& b) { return a | b; }) != 0;
}

/// The values of a function in each lane, for what is too rare for lanes.
template <class Function>
PERILYMPH_IN_LANES double laneByLane(double a, double b, const Function& function) noexcept
{
  return function(a, b);
}
template <class Function>
PERILYMPH_IN_LANES Four laneByLane(const Four& a, const Four& b, const Function& function) noexcept
{
  return Four{function(a[0], b[0]), function(a[1], b[1]), function(a[2], b[2]),
              function(a[3], b[3])};
}

/// The values of a function of a node, or of four nodes, for what is not stored node by node as numbers.
template <class T, class Function>
PERILYMPH_IN_LANES T ofEachNode(std::size_t i, const Function& function) noexcept
{
  if constexpr (sizeof(T) == sizeof(double))
    return function(i);
  else
    return T{function(i), function(i + 1), function(i + 2), function(i + 3)};
}

template <class T>
PERILYMPH_IN_LANES Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) noexcept
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class T>
PERILYMPH_IN_LANES Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) noexcept
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class T>
PERILYMPH_IN_LANES Triple<T> operator*(const T& scale, const Triple<T>& v) noexcept
{
  return {scale * v.x, scale * v.y, scale * v.z};
}

/// In the order of Eigen's dot().
template <class T>
PERILYMPH_IN_LANES T dot(const Triple<T>& a, const Triple<T>& b) noexcept
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
PERILYMPH_IN_LANES Triple<T> cross(const Triple<T>& a, const Triple<T>& b) noexcept
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

PERILYMPH_IN_LANES Four magnitude(const Four& a) noexcept { return a < 0.0 ? -a : a; }

/// Calls a function for each vector, with an axis in each of three lanes; the fourth holds anything.
template <class Function>
PERILYMPH_IN_LANES void forEachVector(const std::vector<Eigen::Vector3d>& vectors,
                                      const Function& function) noexcept
{
  const double* at = componentsOf(vectors);
  const std::size_t last = 3 * (vectors.size() - 1);
  for (std::size_t k = 0; k < last; k += 3) function(load<Four>(at, k));
  function(Four{at[last], at[last + 1], at[last + 2], 0.0});
}

/// The same for the vectors of two arrays.
template <class Function>
PERILYMPH_IN_LANES void forEachVector(const std::vector<Eigen::Vector3d>& vectors,
                                      const std::vector<Eigen::Vector3d>& others,
                                      const Function& function) noexcept
{
  const double* a = componentsOf(vectors);
  const double* b = componentsOf(others);
  const std::size_t last = 3 * (vectors.size() - 1);
  for (std::size_t k = 0; k < last; k += 3) function(load<Four>(a, k), load<Four>(b, k));
  function(Four{a[last], a[last + 1], a[last + 2], 0.0},
           Four{b[last], b[last + 1], b[last + 2], 0.0});
}

}  // namespace perilymph::mechanics
