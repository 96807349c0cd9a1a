#pragma once

#include <TopTools_DataMapOfShapeReal.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

/// Deflections for the triangles of a shape, millimetres.
struct Fineness {
  double deflection = 0.0;                 ///< deflection of all faces
  std::map<double, TopoDS_Compound> fine;  ///< finer faces, by deflection
};

/// The deflections for each solid of an assembly. A cylinder that is closely around a cylinder of another solid gets a
/// finer deflection than the rest of its solid, so that proofs about the fit hold for the surfaces, too. Runs in the
/// importing process only.
class StepFineness {
 public:
  /// `deflection`: for all faces, millimetres; 0: usualDeflection() of each solid, and a share of the radius in close
  /// fits.
  StepFineness(double deflection, const std::vector<StepSolid>& solids);

  /// The deflections for the shape at its origin, scaled by its placement.
  Fineness of(const StepSolid& solid) const;

 private:
  double deflectionOf(const StepSolid& solid) const;

  double deflection_;
  TopTools_DataMapOfShapeReal diagonals_;  ///< by shape, unscaled
  TopTools_DataMapOfShapeReal fine_;       ///< deflection of each face
};

}  // namespace glissade
