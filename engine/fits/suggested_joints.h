#pragma once

#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/fits/joint.h"
#include "engine/fits/product_shapes.h"

namespace glissade {

/// Joints that names, classes and shapes suggest, and that a person confirms: flexible bodies, snaps, welded or glued
/// bodies, and purchased units. Retaining rings and units with the number of their article are recognised. Ordered by
/// body. `classes`: a class for each body, or empty. `found`: recognised joints; nothing is suggested for bodies of a
/// unit among them.
Joints findSuggestedJoints(const ProductShapes& shapes, const std::vector<std::string>& classes, const Joints& found,
                           const StopToken& stop);

/// True if the name says that the body is a retaining ring: "DIN 471 8x0.8", "circlip", "snap ring". It is opened to
/// come out of its groove, by more than hooks bend.
bool isRetainingRing(const std::string& name);

/// The words of a name that say what the part is, in lower case: "zahnriemen 200 mm (#2)": "zahnriemen".
std::vector<std::string> wordsOfName(const std::string& name);

}  // namespace glissade
