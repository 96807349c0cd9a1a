#pragma once

#include <glissade/glissade.h>
#include <pybind11/pybind11.h>

#include <functional>

#include "engine/python/long_call.h"

namespace glissade::python {

/// Adds HandView. Precondition: addValues().
void addOperators(pybind11::module_& module);

/// Sets the operator of a run: the name of a simulated one, or a function of a HandView that returns a pose. `during`:
/// the call of Python's that is under way when the operator is asked. Error: TypeError.
void setOperator(const pybind11::object& hand, const std::function<LongCall&()>& during, PlanOptions& options);

/// Sets the sampler of a run: a function (problem, seed) that returns a function without arguments, which returns a
/// pose; None: none. `during`: as above. Error: TypeError.
void setSampler(const pybind11::object& sampler, const std::function<LongCall&()>& during, PlanOptions& options);

}  // namespace glissade::python
