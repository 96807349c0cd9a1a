#pragma once

#include <string>

namespace glissade {

struct ThreadPitch {
  double pitch = 0.0;  ///< metres
  std::string size;    ///< "M10"
};

/// The coarse pitch of ISO 261 for the nominal diameter that is nearest to this thread's, from M1 to M64. `radius`: of
/// the shaft, metres.
ThreadPitch isoCoarsePitch(double radius);

/// "M10": the nominal size that a thread of this diameter (metres, outside) has to 4 %; empty where it has none.
std::string nominalSize(double diameter);

/// Whether a shaft that is drawn so much thicker than its hole, radially, has a thread in it; else it is pressed in.
/// The threads of a coarse pitch are 0.54 pitches deep, those of the finest pitches of ISO 261 more than 0.15 coarse
/// ones. What the judge does not let be pulled (check::kLeastThreadDepth) has a thread, too. `radius`: of the shaft;
/// metres.
bool isThreadDepth(double radius, double depth);

}  // namespace glissade
