#include "engine/python/failure.h"

namespace glissade::python {
namespace {

const char* nameOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::NoPath: return "no_path";
    case ErrorKind::Usage: return "usage";
    case ErrorKind::MalformedInput: return "malformed_input";
    case ErrorKind::InCollision: return "in_collision";
    case ErrorKind::LimitReached: return "limit_reached";
    case ErrorKind::Interrupted: return "interrupted";
    case ErrorKind::Unwritable: return "unwritable";
    case ErrorKind::Internal: break;
  }
  return "internal";
}

}  // namespace

void addError(py::module_& module) {
  const py::object error = py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
      "glissade.Error",
      "An error of the library. Attributes: kind ('no_path', 'usage', 'malformed_input', 'in_collision',\n"
      "'limit_reached', 'interrupted', 'unwritable' or 'internal'), file, place, reason and advice.",
      PyExc_Exception, nullptr));
  module.attr("Error") = error;
}

void fail(const Diagnostic& why) {
  const py::object type = py::module_::import("glissade._glissade").attr("Error");
  py::object error = type(why.text());
  error.attr("kind") = nameOf(why.kind);
  error.attr("file") = why.file;
  error.attr("place") = why.place;
  error.attr("reason") = why.reason;
  error.attr("advice") = why.advice;
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

}  // namespace glissade::python
