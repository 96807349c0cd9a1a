#pragma once

#include "engine/base/json_formats.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Three coordinates in a list. Reading throws JsonError.
Vector3 readVector(const JsonCursor& at);
/// {"position": [x,y,z], "orientation": [x,y,z,w]}
Pose readPose(const JsonCursor& at);

JsonCursor::Json toJson(const Vector3& v);
JsonCursor::Json toJson(const Pose& pose);

struct VectorFormat {
  Vector3 read(const JsonCursor& at) const { return readVector(at); }
  JsonCursor::Json write(const Vector3& v) const { return toJson(v); }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};
inline constexpr VectorFormat kVector{};

/// A direction of any length, as a unit vector. A direction of unit length within rounding is kept, so that files are
/// read and written without a change.
struct DirectionFormat : VectorFormat {
  Vector3 read(const JsonCursor& at) const;
};

/// A unit quaternion x, y, z, w.
struct QuaternionFormat {
  Quaternion read(const JsonCursor& at) const;
  JsonCursor::Json write(const Quaternion& q) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

template <class Archive>
void describe(Archive& pose, Type<Pose> /*type*/) {
  pose.type("pose");
  pose.required("position", &Pose::position, kVector);
  pose.required("orientation", &Pose::orientation, QuaternionFormat(), "Unit quaternion x, y, z, w.");
}

}  // namespace glissade
