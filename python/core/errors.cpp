// SPDX-License-Identifier: MIT
// Errors as exceptions, a class for each kind.
#include "bindings.hpp"
#include "convexact/error.hpp"

namespace convexact::python {
namespace {

struct Kinds {
  py::object base, not_solid, malformed, unrepresentable, invalid, interrupted, unreadable;
};

Kinds make_kinds(py::module_& module) {
  const auto make = [&](const char* name, const py::tuple& bases, const char* meaning) {
    py::object kind = py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
        (std::string("convexact.") + name).c_str(), meaning, bases.ptr(), nullptr));
    module.attr(name) = kind;
    return kind;
  };
  const auto builtin = [](PyObject* kind) { return py::reinterpret_borrow<py::object>(kind); };
  Kinds kinds;
  kinds.base =
      make("ConvexactError", py::make_tuple(builtin(PyExc_Exception)), "Any error of convexact.");
  kinds.not_solid = make("NotSolid", py::make_tuple(kinds.base),
                         "The input encloses no volume; the message has the proof.");
  kinds.malformed = make("MalformedInput", py::make_tuple(kinds.base, builtin(PyExc_ValueError)),
                         "A file or an array is malformed, or a number is not finite.");
  kinds.unreadable = make("Unreadable", py::make_tuple(kinds.base, builtin(PyExc_OSError)),
                          "A file cannot be read, or is of a kind that is not read.");
  kinds.unrepresentable =
      make("Unrepresentable", py::make_tuple(kinds.base), "Doubles cannot hold the result.");
  kinds.invalid = make("InvalidArgument", py::make_tuple(kinds.base, builtin(PyExc_ValueError)),
                       "An argument that cannot be.");
  kinds.interrupted =
      make("Interrupted", py::make_tuple(kinds.base, builtin(PyExc_KeyboardInterrupt)),
           "The call was ended.");
  return kinds;
}

const py::object& kind_of(const Kinds& kinds, ErrorCode code) {
  switch (code) {
    case ErrorCode::NoInterior:
      return kinds.not_solid;
    case ErrorCode::Malformed:
    case ErrorCode::NotFinite:
      return kinds.malformed;
    case ErrorCode::Unreadable:
      return kinds.unreadable;
    case ErrorCode::Unrepresentable:
      return kinds.unrepresentable;
    case ErrorCode::InvalidArgument:
      return kinds.invalid;
    case ErrorCode::Stopped:
      return kinds.interrupted;
    default:
      return kinds.base;
  }
}

}  // namespace

void add_errors(py::module_& module) {
  // Classes of errors live as long as the interpreter.
  static Kinds& kinds = *new Kinds(make_kinds(module));
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      PyErr_SetString(kind_of(kinds, error.code()).ptr(), error.what());
    }
  });
}

}  // namespace convexact::python
