#pragma once

#include <vector>

#include "engine/session/session.h"

namespace glissade {

/// A snapshot's roadmap as one list, without the dropped edges.
struct GrownRoadmap {
  std::vector<RoadmapNode> nodes;
  std::vector<RoadmapEdge> edges;
};
GrownRoadmap grownRoadmap(const SessionSnapshot& snapshot);

/// True if a search has ended without a path, so that its difficulty can be computed.
inline bool searchFailed(const SessionSnapshot& snapshot) {
  if (snapshot.run == 0 || snapshot.path) return false;
  if (snapshot.state == SessionState::Stopped) return true;
  if (snapshot.state != SessionState::Failed || !snapshot.problem) return false;
  return snapshot.problem->kind == ErrorKind::NoPath || snapshot.problem->kind == ErrorKind::LimitReached;
}

}  // namespace glissade
