#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "engine/import/step_tessellation.h"

namespace glissade {

/// Lines of the protocol about a part without an inside: faces that bound no solid, or a solid without thickness.
/// `part` may be empty.
std::vector<std::string> shapeNotes(const TopoDS_Shape& shape, const StepTriangles& triangles, const std::string& part);

/// A line of the protocol with the number of curves of a product that are on no face; empty if there are none.
std::vector<std::string> curveNotes(const TopoDS_Shape& product, const std::string& part);

}  // namespace glissade
