#pragma once

#include "engine/base/json_reader.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Three coordinates in a list. Reading throws JsonError.
Vector3 readVector(const JsonCursor& at);
/// {"position": [x,y,z], "orientation": [x,y,z,w]}
Pose readPose(const JsonCursor& at);

JsonCursor::Json toJson(const Vector3& v);
JsonCursor::Json toJson(const Pose& pose);

}  // namespace glissade
