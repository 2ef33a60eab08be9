// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Errors, warnings, signals and the interpreter's lock, at the door to Python.

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "perilymph/foundation/Result.h"

namespace perilymph::python {

namespace py = pybind11;

/// An error of the engine: becomes perilymph.Error with the same sentence, which may name a text with
/// a zero in it.
class EngineError : public std::runtime_error {
public:
  explicit EngineError(const std::string& sentence) : runtime_error(sentence), sentence_(sentence)
  {
  }
  const std::string& sentence() const noexcept { return sentence_; }

private:
  std::string sentence_;
};

/// The value of a result. @throws EngineError if it has none.
template <class Value>
Value valueOf(Result<Value> result)
{
  if (!result) throw EngineError(result.error().message);
  if constexpr (!std::is_void_v<Value>) return *std::move(result);
}

/// Text for Python. Bytes that are not UTF-8, possible in names of files, are shown as escapes.
py::str textOf(const std::string& text);

/// Issues the engine's warnings since the last call as Python warnings, with the lock.
/// @throws py::error_already_set if a filter makes one an exception.
void issueWarnings();

/// Calls `work` without the interpreter's lock, then issues the warnings that it caused.
template <class Work>
auto withoutLock(Work&& work)
{
  auto result = [&] {
    const py::gil_scoped_release released;
    return work();
  }();
  issueWarnings();
  return result;
}

/// Signals that arrive and callbacks that raise while a calculation runs without the lock: they end
/// it, and their exception is raised afterwards.
class PendingException {
public:
  /// True if the calculation is to end: Python has a signal whose handler raises, such as Ctrl+C.
  /// Takes the lock for a moment.
  bool isRaised();
  /// The same, after calling `callback` with the lock.
  bool isRaisedBy(const std::function<void()>& callback);
  /// With the lock: raises the exception, if there is one.
  void raise();

private:
  std::optional<py::error_already_set> exception_;
};

/// Defines perilymph.Error, translates every C++ exception, and begins to collect warnings.
void defineErrors(py::module_& module);

}  // namespace perilymph::python
