// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// NumPy arrays at the door to Python: checked on the way in, without a copy on the way out.

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "PythonErrors.h"

namespace perilymph::python {

/// Largest number of values that one call takes (choice, high: 80 MB).
inline constexpr std::size_t maxValues = 10'000'000;

/// Real numbers as given: a number, a sequence or an array of any shape.
struct NumberArray {
  std::vector<py::ssize_t> shape;
  std::vector<double> values;
};

/// Numbers of an argument. Refuses with the argument's name what is not real (TypeError), more than
/// maxValues, and values that are not finite or out of range.
///
/// @param unit  For the message: "mm".
NumberArray numbersOf(const py::object& given, const char* name, const char* unit, double low,
                      double high);

/// Points as given, of shape (..., 3): the shape before the last axis, and the points in meters.
struct PointArray {
  std::vector<py::ssize_t> shape;
  std::vector<Eigen::Vector3d> points;
};
PointArray pointsOf(const py::object& given_mm, const char* name);

/// One number of an argument, finite and within a range.
double numberOf(double value, const char* name, const char* unit, double low, double high);

/// An array of these values, which it takes over.
py::array arrayOf(std::vector<double> values, std::vector<py::ssize_t> shape);
py::array arrayOf(std::vector<double> values);
py::array arrayOf(std::vector<std::int64_t> values);
py::array arrayOf(std::vector<std::int64_t> values, std::vector<py::ssize_t> shape);
/// An array of text.
py::array arrayOf(const std::vector<std::string>& texts);

/// An array of the given shape, of the values of `function` at the numbers.
py::array mapped(const NumberArray& given, const std::function<double(double)>& function);
/// The same for points [m], as millimeters in a last axis of three.
py::array mappedPoints(const NumberArray& given,
                       const std::function<Eigen::Vector3d(double)>& function);

/// A point or vector of three, times a factor.
py::array vectorOf(const Eigen::Vector3d& vector, double factor);

}  // namespace perilymph::python
