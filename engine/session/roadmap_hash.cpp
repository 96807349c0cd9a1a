#include "engine/session/roadmap_hash.h"

#include <cstring>

namespace glissade {
namespace {

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

/// FNV-1a over words, with the high bits folded in: doubles differ there first.
void RoadmapHash::Stream::add(std::uint64_t word) {
  hash = (hash ^ word) * 0x100000001b3U;
  hash ^= hash >> 32U;
}

void RoadmapHash::update(const Planner& planner) {
  const auto& nodes = planner.nodes();
  for (; nodes_.taken < nodes.size(); ++nodes_.taken) add(nodes[nodes_.taken]);
  const auto& edges = planner.edges();
  for (; edges_.taken < edges.size(); ++edges_.taken) {
    edges_.add((std::uint64_t{edges[edges_.taken].from} << 32U) | edges[edges_.taken].to);
  }
  const auto& dropped = planner.droppedEdges();
  for (; dropped_.taken < dropped.size(); ++dropped_.taken) dropped_.add(dropped[dropped_.taken]);
}

void RoadmapHash::add(const RoadmapNode& node) {
  for (int i = 0; i < 3; ++i) nodes_.add(bitsOf(node.q.position[i]));
  for (int i = 0; i < 4; ++i) nodes_.add(bitsOf(node.q.orientation.coeffs()[i]));
  nodes_.add((static_cast<std::uint64_t>(node.author) << 8U) | static_cast<std::uint64_t>(node.side));
}

std::uint64_t RoadmapHash::value() const {
  Stream all;
  for (const Stream* stream : {&nodes_, &edges_, &dropped_}) {
    all.add(stream->hash);
    all.add(stream->taken);
  }
  return all.hash;
}

}  // namespace glissade
