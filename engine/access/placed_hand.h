#pragma once

#include "engine/access/motion_access.h"

namespace glissade {

/// A hand, its forearm and its tool at one configuration of a motion. The forearm's mesh is the person's.
struct PlacedHand {
  MeshPtr hand;
  Pose X_WH;
  Pose X_WF;     ///< of the forearm
  MeshPtr tool;  ///< null: none
  Pose X_WT;
  bool isFree = false;  ///< the nearest sample is
};

/// Where the hand is when the bodies stand at moved * X_WB. Beyond where the hold is free, as it is held there.
/// Precondition: there is a hold.
PlacedHand placedHand(const MotionAccess& motion, const Pose& moved);

}  // namespace glissade
