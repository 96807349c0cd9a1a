#include "engine/import/brep_parts.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <ios>

#include "engine/import/import_refusal.h"
#include "engine/import/loose_parts.h"
#include "engine/import/nothing_read.h"

namespace glissade {

StepAssembly readBrepParts(std::istream& content) {
  constexpr double kGap = 1e-3;
  TopoDS_Shape shape;
  // OpenCASCADE would read without end if an expected word is missing.
  content.exceptions(std::ios::failbit | std::ios::badbit);
  try {
    BRepTools::Read(shape, content, BRep_Builder());
  } catch (const std::ios::failure&) {
    shape.Nullify();
  }
  if (shape.IsNull()) throw ImportRefusal{GLISSADE_TEXT("it is not sound BREP text")};
  StepAssembly assembly = loosePartsOf({shape}, kGap, [](const TopoDS_Shape&) { return std::string(); });
  if (assembly.solids.empty()) throw ImportRefusal{nothingRead(assembly.notes)};
  return assembly;
}

}  // namespace glissade
