#pragma once

namespace glissade {

/// How exactly a picture is drawn. As constructed: in full detail.
struct PictureDetail {
  double tolerance = 0.0;   ///< pixels that what is drawn may be off
  double resolution = 1.0;  ///< pixels along a side that are drawn for each pixel that is shown
  bool smooth = true;       ///< several samples for each pixel
};

/// How exactly the pictures of a window are drawn. While the camera moves or the scene changes, pictures that take long
/// are coarser; after that each picture is finer than the one before, so that input waits for one picture at most.
class DetailControl {
 public:
  /// A picture is about to be drawn. `refines`: nothing has changed since the last one.
  PictureDetail begin(bool refines);
  /// It has been drawn, in so many seconds. True: a finer one is due.
  bool end(double seconds);

 private:
  bool changes_ = false;
  int changed_ = 0;  ///< the step of coarseness of pictures that show a change; 0: as at rest
  int drawn_ = 0;    ///< the step of the last picture
};

}  // namespace glissade
