#pragma once

#include <pybind11/pybind11.h>

namespace glissade::python {

/// Adds Session and Roadmap. Precondition: addValues().
void addSession(pybind11::module_& module);

}  // namespace glissade::python
