#pragma once

#include <string>

namespace glissade {

struct ThreadPitch {
  double pitch = 0.0;  ///< metres
  std::string size;    ///< "M10"
};

/// The coarse pitch of ISO 261 for the nominal diameter nearest to this thread's, from M1 to M64. `radius`: radius of
/// the shaft, metres.
ThreadPitch isoCoarsePitch(double radius);

/// "M10": the nominal size of a thread of this outer diameter (metres), within 4 %; empty if there is none.
std::string nominalSize(double diameter);

/// The pitch of a thread whose hole is drawn as its core (pitchOfCore()), else the coarse one. `radius`: radius of the
/// shaft; metres.
double pitchOfDepth(double radius, double depth);

/// True if a shaft that is drawn thicker than its hole by this radial depth has a thread in it; else it is pressed in.
/// Threads of a coarse pitch are 0.54 pitches deep, those of the finest pitches of ISO 261 more than 0.13 coarse ones.
/// A pair that the judge does not permit to be pulled (evidence::kLeastThreadDepth, evidence::isCoreOfThread()) also
/// has a thread. `radius`: radius of the shaft; metres.
bool isThreadDepth(double radius, double depth);

}  // namespace glissade
