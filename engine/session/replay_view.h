#pragma once

#include "engine/session/replay_track.h"
#include "engine/session/session.h"

namespace glissade {

/// The first nodes and edges of a published roadmap: whole chunks are shared, the last may be cut.
RoadmapChunks roadmapPrefix(const RoadmapChunks& chunks, std::size_t nodes, std::size_t edges);

/// Displays any step of a replayed run as the snapshot of that step. Used by one thread, while another may still be
/// replaying.
class ReplayView {
 public:
  /// `number`: number of this replay, so that its snapshots differ from those of other replays.
  ReplayView(const Problem& problem, std::shared_ptr<const RunLog> log, std::shared_ptr<const ReplayTrack> track,
             std::uint64_t number);

  /// The snapshot after this number of session steps, derived from the replay's latest. `end`: the run ended there.
  SnapshotPtr at(std::uint64_t step, const SessionSnapshot& latest, bool end);

 private:
  void placeHand(std::uint64_t step, SessionSnapshot& snapshot) const;

  Pose start_;
  std::unique_ptr<CollisionQuery> query_;
  std::shared_ptr<const RunLog> log_;
  std::shared_ptr<const ReplayTrack> track_;
  std::uint64_t run_;
  std::uint64_t revision_ = 0;
};

}  // namespace glissade
