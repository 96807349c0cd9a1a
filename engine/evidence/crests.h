#pragma once

#include <optional>

#include "engine/base/stop_token.h"
#include "engine/evidence/crest_helix.h"
#include "engine/evidence/round_faces.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// A thread that is modelled on a body: its crests are a helix, or rings.
struct DrawnCrests {
  Vector3 point = Vector3::Zero();  ///< on their axis, which may be beside that of the wall
  double radius = 0.0;              ///< metres
  double low = 0.0;                 ///< of the crests, along the axis from the point, metres
  double high = 0.0;
  double lead = 0.0;  ///< metres a turn, below 0: left-handed; 0: they are rings
};

/// The crests of a body that go into the wall of a round face of another one: outwards from a shaft into a hole, or
/// inwards from a hole into a shaft. Nothing where the body has none there, where they are not all around the axis of
/// the face, or where they are neither a helix nor three rings or more at equal distances in a hole: a knurl, a smooth
/// cylinder, a collar; also after a stop. `body`: in the frame of the face.
std::optional<DrawnCrests> crestsInto(const RoundFace& face, const TriangleMesh& body, const StopToken& stop = {});

}  // namespace glissade::evidence
