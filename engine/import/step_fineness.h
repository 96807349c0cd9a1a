#pragma once

#include <TopTools_DataMapOfShapeReal.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

/// How fine the triangles of a shape are. Millimetres.
struct Fineness {
  double deflection = 0.0;                 ///< of all faces
  std::map<double, TopoDS_Compound> fine;  ///< finer faces by their deflection
};

/// How fine the triangles of each solid of an assembly are. A cylinder that lies closely around a cylinder of another
/// solid is finer than the rest of its solid, so that what is proved about the fit holds for the surfaces too. Runs in
/// the importing process only.
class StepFineness {
 public:
  /// `deflection` of all faces, millimetres. 0: usualDeflection() of each solid, and what the radius says in close
  /// fits.
  StepFineness(double deflection, const std::vector<StepSolid>& solids);

  /// Of the shape at its own origin, taken as large as its placement says.
  Fineness of(const StepSolid& solid) const;

 private:
  double deflectionOf(const StepSolid& solid) const;

  double deflection_;
  TopTools_DataMapOfShapeReal diagonals_;  ///< by shape, at its own size
  TopTools_DataMapOfShapeReal fine_;       ///< deflection by face
};

}  // namespace glissade
