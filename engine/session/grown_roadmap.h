#pragma once

#include <vector>

#include "engine/session/session.h"

namespace glissade {

/// A snapshot's roadmap in one piece, without the edges that were dropped.
struct GrownRoadmap {
  std::vector<RoadmapNode> nodes;
  std::vector<RoadmapEdge> edges;
};
GrownRoadmap grownRoadmap(const SessionSnapshot& snapshot);

/// A search was made and has ended, or was ended, without a path: it can be asked why.
inline bool searchFailed(const SessionSnapshot& snapshot) {
  if (snapshot.run == 0 || snapshot.path) return false;
  if (snapshot.state == SessionState::Stopped) return true;
  if (snapshot.state != SessionState::Failed || !snapshot.problem) return false;
  return snapshot.problem->kind == ErrorKind::NoPath || snapshot.problem->kind == ErrorKind::LimitReached;
}

}  // namespace glissade
