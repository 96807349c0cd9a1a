#pragma once

#include "engine/access/motion_access.h"

namespace glissade {

/// A hand, its forearm and its tool at one configuration of a motion. The forearm's mesh is the person's.
struct PlacedHand {
  MeshPtr hand;
  Pose X_WH;
  Pose X_WF;     ///< pose of the forearm
  MeshPtr tool;  ///< null: none
  Pose X_WT;
  bool isFree = false;  ///< the nearest sample is free
};

/// The hand when the bodies are at moved * X_WB, by the nearest sample. At a sample that is not free, the wrist has the
/// hold's first bend. Precondition: there is a hold.
PlacedHand placedHand(const MotionAccess& motion, const Pose& moved);

}  // namespace glissade
