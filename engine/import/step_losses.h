#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <string>
#include <vector>

namespace glissade {

/// What a STEP file says and OpenCASCADE has not made of it: faces of shells, boundaries of faces, solids. Each is a
/// line "entity, tab, what is missing", as "#45<tab>its face #12 could not be made". Ask after the transfer. Runs in
/// the importing process only.
std::vector<std::string> lossesOf(const STEPCAFControl_Reader& reader);

}  // namespace glissade
