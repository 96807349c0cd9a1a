#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "engine/check/evidence.h"
#include "engine/product/contact_report.h"
#include "engine/product/thinnable_bodies.h"

namespace glissade {

/// The pitches of threads that are modelled on shafts, each found once, for any number of threads of the program.
class ModelledPitches {
 public:
  /// Metres a turn; nothing where the body is no screw, or has no helix.
  std::optional<double> of(const MeshPtr& mesh);

 private:
  std::mutex mutex_;
  std::map<MeshPtr, std::optional<double>> pitches_;
};

/// A shaft and the body with the hole where they are assembled, and what the evidence gives for either.
struct CoreQuestion {
  ContactBody shaft;
  ContactBody hole;
  const check::AllowanceBound& ofShaft;
  const check::AllowanceBound& ofHole;
  ContactAxis axis;    ///< of both, world frame
  double pitch = 0.0;  ///< of the thread that is modelled on the shaft
};

/// A shaft whose thread is taken away against one other body.
struct CoreFit {
  MeshPtr core;            ///< in the shaft's frame
  double allowance = 0.0;  ///< metres, of the face that moves farthest
  double radiusOfShaft = 0.0;
  double radiusOfHole = 0.0;
};

/// Where the thread of a shaft is modelled as a helix and its hole is drawn narrower than the crests, no face of either
/// body has place for the overlap: the teeth are thin, and so may be the nut. The thread is taken away down to what the
/// faces in the fit leave of the hole (ThreadCore). Nothing where that is more than the evidence, or more than a thread
/// of this pitch and diameter is deep (check::isThreadDepth()).
std::optional<CoreFit> coreFitOf(const CoreQuestion& question, ThinnableBodies& thinnable);

}  // namespace glissade
