#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <optional>
#include <string>

namespace glissade {

/// The first CARTESIAN_TRANSFORMATION_OPERATOR_3D of the file that mirrors or scales, as "#45 mirrors …".
/// OpenCASCADE 7.6 leaves out the mirror and the scale: the instance would be another body than the file's. Ask before
/// the transfer. Runs in the importing process only.
std::optional<std::string> mirrorOrScaleIn(const STEPCAFControl_Reader& reader);

}  // namespace glissade
