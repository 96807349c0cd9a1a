#pragma once

#include <string>

namespace glissade {

struct ThreadPitch {
  double pitch = 0.0;  ///< metres
  std::string size;    ///< "M10" or "1/4"
};

/// The coarse pitch of ISO 261 for the nominal diameter nearest to this thread's, from M1 to M64; the coarse pitch of
/// ASME B1.1 for a shaft that is drawn with the diameter of an inch size, and of no metric one. `radius`: radius of the
/// shaft, metres.
ThreadPitch coarsePitch(double radius);

/// "M10": the nominal size of a thread of this outer diameter (metres), within 4 %; empty if there is none.
std::string nominalSize(double diameter);

/// The pitch of a thread whose hole is drawn as its core (pitchOfCore()), else the coarse one. `radius`: radius of the
/// shaft; metres.
double pitchOfDepth(double radius, double depth);

/// The pitch of a screw in a hole: the one whose core by the standard is the hole (isCoreByStandard()), else the coarse
/// one. `radius`: radius of the shaft; `hole`: radius of the hole; metres.
double pitchOfHole(double radius, double hole);

/// True if a shaft that is drawn thicker than its hole by this radial depth has a thread in it; else it is pressed in.
/// Threads of a coarse pitch are 0.54 pitches deep, those of the finest pitches of ISO 261 more than 0.13 coarse ones.
/// A pair that the judge does not permit to be pulled (evidence::kLeastThreadDepth, evidence::isCoreOfThread()) also
/// has a thread. `radius`: radius of the shaft; metres.
bool isThreadDepth(double radius, double depth);

}  // namespace glissade
