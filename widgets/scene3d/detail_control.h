#pragma once

namespace glissade {

/// Accuracy of a picture; full detail by default.
struct PictureDetail {
  double tolerance = 0.0;   ///< largest error in pixels
  double resolution = 1.0;  ///< pixels along a side that are drawn for each pixel that is shown
  bool smooth = true;       ///< several samples for each pixel
};

/// Controls the accuracy of a window's pictures. While the camera moves or the scene changes, slow pictures become
/// coarser; afterwards each picture is finer than the one before, so that input waits for one picture at most.
class DetailControl {
 public:
  /// Begins a picture and returns its detail. `refines`: nothing has changed since the last picture.
  PictureDetail begin(bool refines);
  /// Ends a picture that took this time. True if a finer one is due.
  bool end(double seconds);

 private:
  bool changes_ = false;
  int changed_ = 0;  ///< step of coarseness of pictures that show a change; 0: full detail
  int drawn_ = 0;    ///< step of the last picture
};

}  // namespace glissade
