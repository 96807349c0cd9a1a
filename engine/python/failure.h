// Diagnostics as Python's exceptions.
#pragma once

#include <glissade/glissade.h>
#include <pybind11/pybind11.h>

#include <utility>

namespace glissade::python {

namespace py = pybind11;

/// Adds the exception glissade.Error with kind, file, place, reason and advice.
void addError(py::module_& module);

/// Throws glissade.Error.
[[noreturn]] void fail(const Diagnostic& why);

/// The value of a result; else glissade.Error.
template <class Value>
Value valueOf(const Result<Value>& result) {
  if (!result) fail(result.error());
  return *result;
}

}  // namespace glissade::python
