// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>

#include "Bindings.h"

namespace perilymph::python {

namespace {

// pybind11 begins a function's documentation with "name(argument: type = default) -> type". Python
// shows a signature of "name(argument=default)\n--\n\n", and hides it in the text.

/// The position behind the bracket that matches the one at `begin`.
std::size_t closing(const std::string& text, std::size_t begin)
{
  int depth = 0;
  bool isText = false;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char each = text[i];
    if (each == '\'') isText = !isText;
    if (isText) continue;
    if (each == '(' || each == '[' || each == '{') ++depth;
    if ((each == ')' || each == ']' || each == '}') && --depth == 0) return i;
  }
  return std::string::npos;
}

/// "argument=default" of "argument: type = default".
std::string plainArgument(const std::string& argument)
{
  if (argument == "*" || argument == "/") return argument;
  const std::size_t colon = argument.find(':');
  const std::string name = argument.substr(0, colon);
  const std::size_t equals = argument.find(" = ");
  return equals == std::string::npos ? name : name + '=' + argument.substr(equals + 3);
}

/// "name(a, b=1)" of the first line; empty if it is not pybind11's, or of several overloads.
std::string plainSignature(const std::string& line)
{
  const std::size_t open = line.find('(');
  if (open == std::string::npos) return {};
  const std::size_t end = closing(line, open);
  if (end == std::string::npos || line.find("*args") != std::string::npos) return {};
  std::string plain, argument;
  int depth = 0;
  bool isText = false;
  const auto take = [&] {
    const std::size_t first = argument.find_first_not_of(' ');
    if (first != std::string::npos)
      plain += (plain.empty() ? "" : ", ") + plainArgument(argument.substr(first));
    argument.clear();
  };
  for (std::size_t i = open + 1; i < end; ++i) {
    const char each = line[i];
    if (each == '\'') isText = !isText;
    if (!isText && (each == '[' || each == '(' || each == '{')) ++depth;
    if (!isText && (each == ']' || each == ')' || each == '}')) --depth;
    if (each == ',' && depth == 0 && !isText)
      take();
    else
      argument += each;
  }
  take();
  return line.substr(0, open) + '(' + plain + ')';
}

/// A copy that lives as long as the interpreter, as functions and classes of a module do.
const char* kept(const std::string& text)
{
  char* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

/// Gives a function its signature.
void giveSignature(PyObject* object)
{
  if (PyInstanceMethod_Check(object)) object = PyInstanceMethod_GET_FUNCTION(object);
  if (!PyCFunction_Check(object)) return;
  PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(object)->m_ml;
  if (definition->ml_doc == nullptr) return;
  const std::string text = definition->ml_doc;
  const std::size_t line = text.find('\n');
  const std::string signature = plainSignature(text.substr(0, line));
  if (signature.empty() || text.find("\n--\n") != std::string::npos) return;
  std::size_t rest = line == std::string::npos ? text.size() : text.find_first_not_of('\n', line);
  if (rest == std::string::npos) rest = text.size();
  definition->ml_doc = kept(signature + "\n--\n\n" + text.substr(rest));
}

}  // namespace

void giveSignatures(const py::module_& module)
{
  for (const auto& [name, value] : module.attr("__dict__").cast<py::dict>()) {
    giveSignature(value.ptr());
    if (!PyType_Check(value.ptr())) continue;
    const py::handle members(reinterpret_cast<PyTypeObject*>(value.ptr())->tp_dict);
    for (const auto& [each, member] : py::reinterpret_borrow<py::dict>(members))
      giveSignature(Py_TYPE(member.ptr()) == &PyStaticMethod_Type
                        ? py::object(member.attr("__func__")).ptr()
                        : member.ptr());
  }
}

}  // namespace perilymph::python
