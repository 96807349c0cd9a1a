#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

namespace glissade {

/// What a STEP file says and OpenCASCADE has not made of it: a face of a shell, a boundary of a face, a solid.
struct StepLoss {
  std::string entity;  ///< "#45"
  std::string what;    ///< "its face #12 could not be made"
  TopoDS_Shape face;   ///< a face of the part that misses it; null: none was made
};

/// Ask after the transfer. Throws std::runtime_error where there are more than 1,000. Runs in the importing process
/// only.
std::vector<StepLoss> lossesOf(const STEPCAFControl_Reader& reader);

}  // namespace glissade
