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

/// The shapes of a file as counted, beside its bodies. Refers to its members for the time of the call.
struct KnownShapes {
  const StepEntities& entities;
  const StatedShapes& stated;
  const StandInShapes& standIns;
  const std::set<std::uint64_t>& second;  ///< items that were taken for second representations
  const ExternalFiles& externalFiles;
};

/// A line of the protocol about each shape that the file states and that is in none of `bodies` where the file has it,
/// about each product without a shape that is in no other file, and about each orphan that is read as a body.
/// Compares what statedShapesOf() counts with the bodies that were made. Runs in the importing process only.
std::vector<std::string> missingShapeLines(const STEPCAFControl_Reader& reader, const KnownShapes& known,
                                           const std::vector<TopoDS_Shape>& bodies);

}  // namespace glissade
