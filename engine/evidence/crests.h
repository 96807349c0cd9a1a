#pragma once

#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/evidence/round_faces.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// A point about an axis.
struct Around {
  double radius;
  double height;
  double angle;  ///< radians
};

/// Each vertex about an axis. `axis`: unit.
std::vector<Around> aroundOf(const TriangleMesh& mesh, const Vector3& point, const Vector3& axis);

/// The vertices leave no gap about the axis that is wider than a little more than a quarter of a turn.
bool areAround(const std::vector<Around>& vertices);

/// Whether the crests are a helix of one start with this pitch, to three percent: after a turn back by the pitch they
/// are on one side of the axis, and on the same side in the lower and in the upper half of the thread. `crests`: in the
/// order of their heights.
bool areHelix(const std::vector<Around>& crests, double pitch);

/// A thread that is modelled on a body: its crests are a helix, or rings.
struct DrawnCrests {
  Vector3 point = Vector3::Zero();  ///< on their axis, which may be beside that of the wall
  double radius = 0.0;              ///< metres
  double low = 0.0;                 ///< of the crests, along the axis from the point, metres
  double high = 0.0;
  double pitch = 0.0;  ///< metres a turn, below 0: left-handed; 0: they are rings
};

/// The crests of a body that go into the wall of a round face of another one: outwards from a shaft into a hole, or
/// inwards from a hole into a shaft. Nothing where the body has none there, where they are not all around the axis of
/// the face, or where they are neither a helix of one start nor three rings or more at equal distances in a hole: a
/// knurl, a smooth cylinder, a collar, a thread of several starts; also after a stop. `body`: in the frame of the face.
std::optional<DrawnCrests> crestsInto(const RoundFace& face, const TriangleMesh& body, const StopToken& stop = {});

}  // namespace glissade::evidence
