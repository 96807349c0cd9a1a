#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

class CameraController;

/// How exactly the pictures of a window are drawn. While the camera moves, pictures that take long are coarser; once it
/// rests, each picture is finer than the one before, so that input waits for one picture at most.
class DetailControl {
 public:
  /// A picture is about to be drawn from here. Returns how far, in pixels, what is drawn may be off.
  double begin(const CameraController& camera);
  /// It has been drawn, in so many seconds. True: a finer one is due.
  bool end(double seconds);

 private:
  Vector3 eye_ = Vector3::Zero();
  Quaternion R_WV_ = Quaternion::Identity();
  double viewHeight_ = 0.0;
  bool moving_ = false;
  double moved_ = 1.0;  ///< the tolerance while the camera moves
  double drawn_ = 1.0;  ///< the tolerance of the last picture
};

}  // namespace glissade
