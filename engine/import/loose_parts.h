#pragma once

#include <TopoDS_Shape.hxx>
#include <functional>
#include <string>
#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

/// Returns the name that a file gives to a shape; empty if it gives none.
using ShapeName = std::function<std::string(const TopoDS_Shape&)>;

/// The parts of shapes that no product describes, as IGES and BREP files hold them. A compound with solids or compounds
/// in it is an assembly; any other one is a part. Faces that belong to no solid are sewn together where they are nearer
/// than `tolerance` (millimetres), at most a ten-thousandth of the diagonal of all; what is closed then is a solid. A
/// part of several solids has them below it. There may be none. Throws std::runtime_error where there are too many.
/// Runs in the importing process only.
StepAssembly loosePartsOf(const std::vector<TopoDS_Shape>& roots, double tolerance, const ShapeName& nameOf);

}  // namespace glissade
