#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/import/step_measures.h"
#include "engine/import/step_validation.h"

namespace glissade {

/// A solid of the file, as it was triangulated.
struct ValidatedSolid {
  std::string path;
  TriangleMeasures measures;
};

/// Lines of the protocol about products whose triangles differ from what the file states of them: in volume by more
/// than the deflection of the triangles times their area, in the centroid by more than that volume could move it, in
/// area by more than facets of the angle that was asked for explain. `solidOf` is asked for solids at their own
/// origins, and gives null where it does not know one. Products with faces that bound no solid are not compared.
std::vector<std::string> validationNotes(const std::vector<StatedMeasures>& stated,
                                         const std::function<const ValidatedSolid*(const TopoDS_Shape&)>& solidOf);

}  // namespace glissade
