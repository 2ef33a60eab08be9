// SPDX-License-Identifier: BSD-3-Clause
#include "PythonErrors.h"

#include <exception>
#include <mutex>
#include <new>
#include <string_view>
#include <vector>

#include "perilymph/foundation/RenamedKeys.h"

namespace perilymph::python {

namespace {

/// The class perilymph.Error. Lives as long as the interpreter.
PyObject* errorClass = nullptr;

/// Warnings of the engine, from any thread.
struct Warnings {
  std::mutex lock;
  std::vector<std::string> waiting;
};
Warnings& warnings()
{
  static Warnings all;
  return all;
}

void setError(const std::string& sentence) { PyErr_SetObject(errorClass, textOf(sentence).ptr()); }

// Exceptions that pybind11 knows itself are left to it: memory, types and values of its own.
void translate(std::exception_ptr thrown)
{
  if (!thrown) return;
  try {
    std::rethrow_exception(thrown);
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const py::error_already_set&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const EngineError& error) {
    setError(error.sentence());
  } catch (const std::invalid_argument& error) {
    setError(error.what());
  } catch (const std::exception& error) {
    setError(std::string("An internal error stopped the calculation: ") + error.what() + ".");
  }
}

}  // namespace

py::str textOf(const std::string& text)
{
  PyObject* decoded =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace");
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

void issueWarnings()
{
  std::vector<std::string> now;
  {
    const std::lock_guard guard(warnings().lock);
    now.swap(warnings().waiting);
  }
  for (const std::string& each : now)
    if (PyErr_WarnEx(PyExc_UserWarning, std::string(py::str(textOf(each))).c_str(), 1) != 0)
      throw py::error_already_set();
}

bool PendingException::isRaised()
{
  return isRaisedBy([] {});
}

bool PendingException::isRaisedBy(const std::function<void()>& callback)
{
  if (exception_) return true;
  const py::gil_scoped_acquire locked;
  try {
    callback();
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  } catch (const py::error_already_set& error) {
    exception_ = error;
  }
  return exception_.has_value();
}

void PendingException::raise()
{
  if (!exception_) return;
  const py::error_already_set error = *exception_;
  exception_.reset();
  throw error;
}

void defineErrors(py::module_& module)
{
  errorClass = PyErr_NewExceptionWithDoc(
      "perilymph.Error",
      "An operation failed. Its text is one or two sentences: what, where, which value, what is "
      "allowed, what to do.",
      PyExc_ValueError, nullptr);
  if (errorClass == nullptr) throw py::error_already_set();
  module.add_object("Error", py::reinterpret_borrow<py::object>(errorClass));
  py::register_local_exception_translator(translate);
  setWarningHandler([](const std::string& warning) {
    const std::lock_guard guard(warnings().lock);
    warnings().waiting.push_back(warning);
  });
}

}  // namespace perilymph::python
