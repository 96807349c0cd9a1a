#pragma once

#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/product/joint.h"
#include "engine/product/product_shapes.h"

namespace glissade {

/// Joints that names, classes and shapes hint at, and that a person confirms: flexible bodies, snaps, what is welded or
/// glued, and purchased units. By body. `classes`: a class for each body, or none at all. `found`: what was recognised;
/// of the bodies of a unit among these nothing is suggested.
Joints findSuggestedJoints(const ProductShapes& shapes, const std::vector<std::string>& classes, const Joints& found,
                           const StopToken& stop);

/// The words of a name that say what it is, in lower case: "zahnriemen 200 mm (#2)": "zahnriemen".
std::vector<std::string> wordsOfName(const std::string& name);

}  // namespace glissade
