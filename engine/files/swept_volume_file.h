#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/places/rigid_body.h"
#include "engine/sweep/swept_volume.h"

namespace glissade {

/// Saves a swept volume as binary STL (.stl, in millimetres, as most readers expect) or as GLB (.glb, metres, with a
/// name and a colour), by the ending. Coordinates are rounded to 32 bits, which the bound includes. Errors name the
/// file: another ending (Usage), or a file that cannot be written.
Outcome saveSweptVolume(const SweptVolume& sweep, const std::string& name, const Colour& colour,
                        const std::string& file, Warnings& warnings);

}  // namespace glissade
