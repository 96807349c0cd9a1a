#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "engine/check/evidence.h"
#include "engine/check/thread_core.h"
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

/// One body of a pair where it is assembled.
struct CoreSide {
  ContactBody body;
  const check::PlacedBody& placed;
  const check::AllowanceBound& bound;  ///< what the evidence gives, were the overlap no clash
};

/// A shaft whose thread is taken away against one other body.
struct CoreFit {
  check::ThreadCore core;  ///< world frame
  MeshPtr mesh;            ///< what is left of the shaft, in its frame
  ContactAxis axis;        ///< of both; the shaft is `a`
};

/// Where the thread of a shaft is modelled as a helix and its hole is drawn narrower than the crests, no face of either
/// body has place for the overlap: the teeth are thin, and so may be the nut. The thread is taken away where the judge
/// finds it (check::threadCoreOf()), and faces beside it are taken thinner by what they touch. `pitch`: metres a turn.
std::optional<CoreFit> coreFitOf(const CoreSide& shaft, const CoreSide& hole, double pitch, ThinnableBodies& thinnable);

}  // namespace glissade
