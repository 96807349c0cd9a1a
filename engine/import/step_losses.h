#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "engine/base/message.h"

namespace glissade {

/// An entity of a STEP file that OpenCASCADE has not made: a face of a shell, a boundary of a face, a solid.
struct StepLoss {
  std::string entity;  ///< "#45"
  Message what;        ///< "its face #12 could not be made"
  TopoDS_Shape face;   ///< a face of the part with the loss; null: none was made
};

/// Precondition: the transfer is done. Throws ImportRefusal if there are more than 1,000 losses. Runs in the
/// importing process only.
std::vector<StepLoss> lossesOf(const STEPCAFControl_Reader& reader);

}  // namespace glissade
