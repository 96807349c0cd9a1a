#pragma once

#include <pybind11/pybind11.h>

namespace glissade::python {

/// Adds the library's functions. Precondition: addValues().
void addFunctions(pybind11::module_& module);

}  // namespace glissade::python
