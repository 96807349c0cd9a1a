#include "engine/session/grown_roadmap.h"

#include <algorithm>
#include <set>

namespace glissade {

GrownRoadmap grownRoadmap(const SessionSnapshot& snapshot) {
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> dropped;
  for (const RoadmapEdge& edge : snapshot.droppedEdges) dropped.insert(std::minmax(edge.from, edge.to));
  GrownRoadmap grown;
  for (const auto& chunk : snapshot.roadmap) {
    grown.nodes.insert(grown.nodes.end(), chunk->nodes.begin(), chunk->nodes.end());
    for (const RoadmapEdge& edge : chunk->edges) {
      const auto found = dropped.find(std::minmax(edge.from, edge.to));
      if (found == dropped.end()) {
        grown.edges.push_back(edge);
      } else {
        dropped.erase(found);
      }
    }
  }
  return grown;
}

}  // namespace glissade
