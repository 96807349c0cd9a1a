#include "engine/planning/roadmap_graph.h"

#include <algorithm>
#include <limits>

namespace glissade {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace

RoadmapGraph::Node RoadmapGraph::addRoot(const RoadmapNode& node) {
  const auto index = static_cast<Node>(nodes_.size());
  const auto component = static_cast<ComponentId>(members_.size());
  nodes_.push_back(node);
  links_.emplace_back();
  componentOf_.push_back(component);
  members_.emplace_back(metric_);
  members_.back().add(index, node.q);
  return index;
}

RoadmapGraph::Node RoadmapGraph::addChild(Node parent, const RoadmapNode& node) {
  const auto index = static_cast<Node>(nodes_.size());
  const ComponentId component = componentOf_[parent];
  nodes_.push_back(node);
  links_.emplace_back();
  componentOf_.push_back(component);
  members_[component].add(index, node.q);
  addEdge(parent, index);
  return index;
}

void RoadmapGraph::join(Node a, Node b) {
  // The younger component is absorbed, so that the start's component keeps its identity.
  const ComponentId older = std::min(componentOf_[a], componentOf_[b]);
  const ComponentId younger = std::max(componentOf_[a], componentOf_[b]);
  moveToComponent(componentOf_[a] == younger ? a : b, older);
  members_[younger] = NearestNeighbours(metric_);
  addEdge(a, b);
}

void RoadmapGraph::dropEdge(std::uint32_t edge) {
  const auto [from, to] = edges_[edge];
  const auto unlink = [&](Node node) {
    auto& links = links_[node];
    links.erase(std::find_if(links.begin(), links.end(), [&](const Link& link) { return link.edge == edge; }));
  };
  unlink(from);
  unlink(to);
  dropped_.push_back(edge);

  const ComponentId whole = componentOf_[from];
  const auto split = static_cast<ComponentId>(members_.size());
  members_.emplace_back(metric_);
  moveToComponent(to, split);
  NearestNeighbours remaining(metric_);
  for (Node node = 0; node < nodes_.size(); ++node) {
    if (componentOf_[node] == whole) remaining.add(node, nodes_[node].q);
  }
  members_[whole] = std::move(remaining);
}

std::vector<RoadmapGraph::ComponentId> RoadmapGraph::components() const {
  std::vector<ComponentId> result;
  for (ComponentId component = 0; component < members_.size(); ++component) {
    if (members_[component].size() > 0) result.push_back(component);
  }
  return result;
}

NearestNeighbours::Neighbour RoadmapGraph::nearest(ComponentId component, const Pose& q) const {
  return *members_[component].nearest(q);
}

std::optional<RoadmapGraph::Way> RoadmapGraph::way(Node from, Node to) const {
  if (!connected(from, to)) return std::nullopt;
  // Breadth first from the far end, so that following the links back reads forwards.
  std::vector<Link> next(nodes_.size(), Link{kNone, kNone});
  std::vector<Node> queue{to};
  next[to].node = to;
  for (std::size_t head = 0; head < queue.size() && next[from].node == kNone; ++head) {
    for (const Link& link : links_[queue[head]]) {
      if (next[link.node].node != kNone) continue;
      next[link.node] = {queue[head], link.edge};
      queue.push_back(link.node);
    }
  }
  Way result;
  result.nodes.push_back(from);
  for (Node node = from; node != to; node = next[node].node) {
    result.edges.push_back(next[node].edge);
    result.nodes.push_back(next[node].node);
  }
  return result;
}

void RoadmapGraph::addEdge(Node a, Node b) {
  const auto edge = static_cast<std::uint32_t>(edges_.size());
  edges_.push_back({a, b});
  links_[a].push_back({b, edge});
  links_[b].push_back({a, edge});
}

void RoadmapGraph::moveToComponent(Node seed, ComponentId component) {
  std::vector<Node> queue{seed};
  const ComponentId old = componentOf_[seed];
  componentOf_[seed] = component;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (const Link& link : links_[queue[head]]) {
      if (componentOf_[link.node] != old) continue;
      componentOf_[link.node] = component;
      queue.push_back(link.node);
    }
  }
  std::sort(queue.begin(), queue.end());
  for (const Node node : queue) members_[component].add(node, nodes_[node].q);
}

}  // namespace glissade
