#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "engine/import/step_tessellation.h"

namespace glissade {

/// What a part is where it has no inside, as lines of the protocol: faces that bound no solid, or a solid without
/// thickness. `part` may be empty.
std::vector<std::string> shapeNotes(const TopoDS_Shape& shape, const StepTriangles& triangles, const std::string& part);

/// How many curves of a product lie on no face, as a line of the protocol; none where all do.
std::vector<std::string> curveNotes(const TopoDS_Shape& product, const std::string& part);

}  // namespace glissade
