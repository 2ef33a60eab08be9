// SPDX-License-Identifier: BSD-3-Clause
#include "NumberArrays.h"

#include <cmath>
#include <memory>

#include "perilymph/session/Csv.h"

namespace perilymph::python {

namespace {

using session::shortestDecimal;

std::string rangeText(double low, double high, const char* unit)
{
  return shortestDecimal(low) + " to " + shortestDecimal(high) + " " + unit;
}

[[noreturn]] void refuse(const char* name, double value, const char* unit, double low, double high)
{
  throw EngineError(std::string(name) + " has the value " + shortestDecimal(value) +
                    "; allowed are " + rangeText(low, high, unit) + ". Correct it.");
}

/// An array that keeps a vector alive.
template <class Value>
py::array ownedArray(std::vector<Value> values, std::vector<py::ssize_t> shape)
{
  auto owner = std::make_unique<std::vector<Value>>(std::move(values));
  const Value* first = owner->data();
  const py::capsule keeper(owner.get(),
                           [](void* kept) { delete static_cast<std::vector<Value>*>(kept); });
  owner.release();
  return py::array_t<Value>(std::move(shape), first, keeper);
}

}  // namespace

NumberArray numbersOf(const py::object& given, const char* name, const char* unit, double low,
                      double high)
{
  if (py::hasattr(given, "mask") && py::hasattr(given, "filled"))
    throw py::type_error(std::string(name) + " must not be masked: use compressed() or filled()");
  const py::array array = py::array::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " must be numbers, in " + unit);
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error(std::string(name) + " must be real numbers, in " + unit);
  // Before anything is copied: a view of few values can have any size.
  if (static_cast<std::size_t>(array.size()) > maxValues)
    throw EngineError(std::string(name) + " has " + std::to_string(array.size()) +
                      " values; one call takes " + std::to_string(maxValues) +
                      " at most. Divide it.");
  const auto numbers =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!numbers) throw py::error_already_set();
  NumberArray found;
  found.shape.assign(numbers.shape(), numbers.shape() + numbers.ndim());
  found.values.assign(numbers.data(), numbers.data() + numbers.size());
  for (const double value : found.values)
    if (!(value >= low && value <= high)) refuse(name, value, unit, low, high);
  return found;
}

PointArray pointsOf(const py::object& given_mm, const char* name)
{
  // No cochlea is larger than some centimeters; a meter is a mistaken unit (choice, high).
  constexpr double farthest_mm = 1000.0;
  NumberArray numbers = numbersOf(given_mm, name, "mm", -farthest_mm, farthest_mm);
  if (numbers.shape.empty() || numbers.shape.back() != 3)
    throw EngineError(
        std::string(name) +
        " must have the shape (..., 3): x, y and z in mm. Give three values per point.");
  PointArray found;
  found.shape.assign(numbers.shape.begin(), numbers.shape.end() - 1);
  found.points.reserve(numbers.values.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.values.size(); i += 3)
    found.points.emplace_back(numbers.values[i] / 1e3, numbers.values[i + 1] / 1e3,
                              numbers.values[i + 2] / 1e3);
  return found;
}

double numberOf(double value, const char* name, const char* unit, double low, double high)
{
  if (!(value >= low && value <= high)) refuse(name, value, unit, low, high);
  return value;
}

py::array arrayOf(std::vector<double> values, std::vector<py::ssize_t> shape)
{
  return ownedArray(std::move(values), std::move(shape));
}

py::array arrayOf(std::vector<double> values)
{
  const auto count = static_cast<py::ssize_t>(values.size());
  return ownedArray(std::move(values), {count});
}

py::array arrayOf(std::vector<std::int64_t> values)
{
  const auto count = static_cast<py::ssize_t>(values.size());
  return ownedArray(std::move(values), {count});
}

py::array arrayOf(std::vector<std::int64_t> values, std::vector<py::ssize_t> shape)
{
  return ownedArray(std::move(values), std::move(shape));
}

py::array arrayOf(const std::vector<std::string>& texts)
{
  py::list list;
  for (const std::string& text : texts) list.append(textOf(text));
  return py::module_::import("numpy").attr("array")(list, py::arg("dtype") = py::str("str"));
}

py::array mapped(const NumberArray& given, const std::function<double(double)>& function)
{
  std::vector<double> values = withoutLock([&] {
    std::vector<double> found;
    found.reserve(given.values.size());
    for (const double each : given.values) found.push_back(function(each));
    return found;
  });
  return arrayOf(std::move(values), given.shape);
}

py::array mappedPoints(const NumberArray& given,
                       const std::function<Eigen::Vector3d(double)>& function)
{
  std::vector<double> values = withoutLock([&] {
    std::vector<double> found;
    found.reserve(3 * given.values.size());
    for (const double each : given.values) {
      const Eigen::Vector3d point = function(each);
      for (int axis = 0; axis < 3; ++axis) found.push_back(point[axis] * 1e3);
    }
    return found;
  });
  std::vector<py::ssize_t> shape = given.shape;
  shape.push_back(3);
  return arrayOf(std::move(values), std::move(shape));
}

py::array vectorOf(const Eigen::Vector3d& vector, double factor)
{
  return arrayOf(
      std::vector<double>{vector.x() * factor, vector.y() * factor, vector.z() * factor});
}

}  // namespace perilymph::python
