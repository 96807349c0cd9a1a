// The Python module glissade._glissade: the public values and functions with NumPy arrays.
#include "engine/python/failure.h"
#include "engine/python/functions.h"
#include "engine/python/layers.h"
#include "engine/python/operators.h"
#include "engine/python/session.h"
#include "engine/python/values.h"

PYBIND11_MODULE(_glissade, module) {
  module.attr("__version__") = glissade::libraryVersion();
  glissade::python::addError(module);
  glissade::python::addValues(module);
  glissade::python::addOperators(module);
  glissade::python::addFunctions(module);
  glissade::python::addLayers(module);
  glissade::python::addSession(module);
}
