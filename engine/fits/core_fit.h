#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "engine/evidence/evidence.h"
#include "engine/evidence/thread_core.h"
#include "engine/fits/contact_report.h"
#include "engine/fits/thinnable_bodies.h"

namespace glissade {

/// Pitches of threads that are modelled on shafts, each found once. Thread-safe.
class ModelledPitches {
 public:
  /// Metres a turn; nothing if the body is no screw, or has no helix.
  std::optional<double> of(const MeshPtr& mesh);

 private:
  std::mutex mutex_;
  std::map<MeshPtr, std::optional<double>> pitches_;
};

/// An assembled body of a pair.
struct CoreSide {
  ContactBody body;
  const evidence::PlacedBody& placed;
  const evidence::AllowanceBound& bound;  ///< bounds of the evidence, if the overlap were no clash
};

/// A shaft whose thread is taken away against one other body.
struct CoreFit {
  evidence::ThreadCore core;  ///< world frame
  MeshPtr mesh;               ///< remainder of the shaft, in its frame
  ContactAxis axis;           ///< common axis; the shaft is `a`
};

/// If the thread of a shaft is modelled as a helix and its hole is drawn narrower than the crests, neither body has
/// room for the overlap: the teeth are thin, and the nut may be, too. The thread is taken away where the judge finds it
/// (evidence::threadCoreOf()), and touching faces beside it get an allowance. `pitch`: metres a turn.
std::optional<CoreFit> coreFitOf(const CoreSide& shaft, const CoreSide& hole, double pitch, ThinnableBodies& thinnable);

}  // namespace glissade
