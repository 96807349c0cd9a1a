#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "engine/import/step_note.h"
#include "engine/import/step_tessellation.h"

namespace glissade {

/// Notes about a part without an inside: faces that bound no solid, a solid without thickness, or one whose triangles
/// are open at some of its faces.
/// `part` may be empty.
StepNotes shapeNotes(const TopoDS_Shape& shape, const StepTriangles& triangles, const std::string& part);

/// A note with the number of curves of a product that are on no face; empty if there are none.
StepNotes curveNotes(const TopoDS_Shape& product, const std::string& part);

}  // namespace glissade
