#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/import/step_measures.h"
#include "engine/import/step_note.h"
#include "engine/import/step_validation.h"

namespace glissade {

/// A solid of the file, with measures of its triangles.
struct ValidatedSolid {
  std::string path;
  TriangleMeasures measures;
};

/// Notes about products whose triangles differ from the measures that the file states: in volume by
/// more than the deflection of the triangles times their area, in the centroid by more than the displacement that this
/// volume can cause, or in area by more than facets of the requested angle explain. `solidOf` is called with solids at
/// their origins, and returns null for an unknown one. Products with faces that bound no solid are not compared.
StepNotes validationNotes(const std::vector<StatedMeasures>& stated,
                          const std::function<const ValidatedSolid*(const TopoDS_Shape&)>& solidOf);

}  // namespace glissade
