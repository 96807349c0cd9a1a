#pragma once

#include "engine/base/stop_token.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// Evidence on the cut of one of two overlapping bodies.
///
/// The surface of each connected part of the overlap consists of pieces of both bodies. The pieces of `other` are the
/// walls of the cut in `one`, and the reverse. If the walls of a part are one connected surface, the remainder of the
/// body is as connected as the whole body: each way through the part can follow the wall instead. If the walls are
/// several surfaces, the cut goes through the body: a rod falls apart, and a ring opens. Two wall pieces are connected
/// if they share an edge that is deeper in the body than the deviations of the files.
struct CutShape {
  /// The body with the hole is the one whose walls enclose the other body. `Either`: the walls are flat, and neither
  /// body encloses the other.
  enum class Hole { One, Other, Either, Unclear };

  bool oneStaysWhole = false;  ///< the remainder of `one` after the cut is as connected as `one`
  bool otherStaysWhole = false;
  Hole hole = Hole::Unclear;
};

/// Neither body stays whole and the hole is unclear if a surface is not closed, if the bodies overlap by no more than
/// the deviations of the files, if there are too many pieces, or after a stop.
CutShape cutShapeOf(const PlacedBody& one, const PlacedBody& other, const StopToken& stop = {});

/// The body of a pair that is cut if a person accepts their clash.
enum class Cut { One, Other, NotClear, NotWhole };

/// `namesOne`, `namesOther`: a person names this body as the one that is cut. Without a name the body with the hole is
/// cut. `NotClear`: a person has to name a body. `NotWhole`: the remainder would be less connected than the body.
Cut cutOf(const CutShape& shape, bool namesOne, bool namesOther);

}  // namespace glissade::evidence
