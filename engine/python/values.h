#pragma once

#include <pybind11/pybind11.h>

namespace glissade::python {

/// Adds the classes of the library's values.
void addValues(pybind11::module_& module);

}  // namespace glissade::python
