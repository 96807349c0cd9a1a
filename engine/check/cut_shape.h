#pragma once

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// The evidence of the overlap of two bodies about cutting one of them.
///
/// The surface of each connected part of the overlap consists of pieces of both bodies. The pieces of the other body
/// are the walls of the cut in the one. Where the walls of a part are one connected surface, what is left of the body
/// is as connected as before: every way through the part leads along the wall instead. Where they are several, the cut
/// goes through the body: a rod falls apart, and a ring opens. Pieces of walls hang together where they share an edge
/// that is deeper in the body than what the files may be off.
struct CutShape {
  /// The body with the hole is the one whose walls are around the other one. `Either`: the walls are flat, and no body
  /// is around the other one.
  enum class Hole { One, Other, Either, Unclear };

  bool oneStaysWhole = false;  ///< cut, the one is as connected as before
  bool otherStaysWhole = false;
  Hole hole = Hole::Unclear;
};

/// Nothing is whole and the hole is unclear where a surface is not closed, where the bodies do not overlap by more than
/// what the files may be off, where the pieces are too many, or after a stop.
CutShape cutShapeOf(const PlacedBody& one, const PlacedBody& other, const StopToken& stop = {});

/// Which body of a pair is cut where a person accepts their clash.
enum class Cut { One, Other, NotClear, NotWhole };

/// `namesOne`, `namesOther`: a person says that this body is the one that is cut. Without that it is the one with the
/// hole. `NotClear`: a person has to name one. `NotWhole`: what is left would not be one piece as before.
Cut cutOf(const CutShape& shape, bool namesOne, bool namesOther);

}  // namespace glissade::check
