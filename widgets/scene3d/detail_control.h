#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

class CameraController;

/// How exactly a picture is drawn. As constructed: in full detail.
struct PictureDetail {
  double tolerance = 0.0;   ///< pixels that what is drawn may be off
  double resolution = 1.0;  ///< pixels along a side that are drawn for each pixel that is shown
  bool smooth = true;       ///< several samples for each pixel
};

/// How exactly the pictures of a window are drawn. While the camera moves, pictures that take long are coarser; once it
/// rests, each picture is finer than the one before, so that input waits for one picture at most.
class DetailControl {
 public:
  /// A picture is about to be drawn from here.
  PictureDetail begin(const CameraController& camera);
  /// It has been drawn, in so many seconds. True: a finer one is due.
  bool end(double seconds);

 private:
  Vector3 eye_ = Vector3::Zero();
  Quaternion R_WV_ = Quaternion::Identity();
  double viewHeight_ = 0.0;
  bool moving_ = false;
  int moved_ = 0;  ///< the step of coarseness while the camera moves; 0: as at rest
  int drawn_ = 0;  ///< the step of the last picture
};

}  // namespace glissade
