#pragma once

#include <pybind11/pybind11.h>

namespace glissade::python {

/// Adds Layers with its values. Precondition: addValues().
void addLayers(pybind11::module_& module);

}  // namespace glissade::python
