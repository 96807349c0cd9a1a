#pragma once

#include <TopoDS_Shape.hxx>
#include <functional>
#include <string>
#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

/// Returns the name that a file gives to a shape; empty if it gives none.
using ShapeName = std::function<std::string(const TopoDS_Shape&)>;

/// The parts of shapes that no product describes, as in IGES and BREP files. A compound that contains solids or
/// compounds is an assembly; any other compound is a part. Faces that belong to no solid are sewn together if their gap
/// is less than `tolerance` (millimetres), at most a ten-thousandth of the diagonal of all; closed results are solids.
/// A part with several solids has them below it. The result may be empty. Throws ImportRefusal if there are too
/// many parts. Runs in the importing process only.
StepAssembly loosePartsOf(const std::vector<TopoDS_Shape>& roots, double tolerance, const ShapeName& nameOf);

}  // namespace glissade
