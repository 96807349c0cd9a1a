#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "engine/import/step_external_files.h"
#include "engine/import/step_stand_in_shapes.h"
#include "engine/import/step_stated_shapes.h"

namespace glissade {

/// The counted shapes of a file, apart from its bodies. Refers to its members during the call.
struct KnownShapes {
  const StepEntities& entities;
  const StatedShapes& stated;
  const StandInShapes& standIns;
  const std::set<std::uint64_t>& second;  ///< items that were classified as second representations
  const ExternalFiles& externalFiles;
};

/// Notes about each stated shape that is in none of `bodies` at its place, each product without a shape
/// that is in no other file, and each orphan that is read as a body. Compares the result of statedShapesOf() with the
/// bodies that were made. Runs in the importing process only.
StepNotes missingShapeNotes(const STEPCAFControl_Reader& reader, const KnownShapes& known,
                            const std::vector<TopoDS_Shape>& bodies);

}  // namespace glissade
