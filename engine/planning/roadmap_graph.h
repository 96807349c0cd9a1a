#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/planning/nearest_neighbours.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// A growing roadmap whose connected components are trees: every node knows its component, every
/// component can be searched for its nearest node. Joining two components is an edge like any other.
class RoadmapGraph {
 public:
  using Node = std::uint32_t;
  using ComponentId = std::uint32_t;

  explicit RoadmapGraph(const Se3Metric& metric) : metric_(metric) {}

  /// A node that is a component of its own.
  Node addRoot(const RoadmapNode& node);
  /// A node in the component of `parent`, with the edge to it.
  Node addChild(Node parent, const RoadmapNode& node);
  /// Joins two components. Precondition: they differ.
  void join(Node a, Node b);
  /// Takes an edge out of the search: its component falls into two.
  void dropEdge(std::uint32_t edge);

  /// Components in the order of their oldest node.
  std::vector<ComponentId> components() const;
  ComponentId componentOf(Node node) const { return componentOf_[node]; }
  bool connected(Node a, Node b) const { return componentOf_[a] == componentOf_[b]; }
  NearestNeighbours::Neighbour nearest(ComponentId component, const Pose& q) const;

  /// The edges (indices) from one node to another of the same component, with the nodes: nodes.size() == edges.size() +
  /// 1.
  struct Way {
    std::vector<Node> nodes;
    std::vector<std::uint32_t> edges;
  };
  std::optional<Way> way(Node from, Node to) const;

  const std::vector<RoadmapNode>& nodes() const { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const { return dropped_; }
  /// Number of edges in both directions, without the dropped ones: the papers' count.
  std::uint64_t directedEdgeCount() const { return 2 * (edges_.size() - dropped_.size()); }

 private:
  struct Link {
    Node node;
    std::uint32_t edge;
  };

  void addEdge(Node a, Node b);
  void moveToComponent(Node seed, ComponentId component);

  Se3Metric metric_;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  std::vector<std::vector<Link>> links_;  ///< links of each node, without dropped edges
  std::vector<ComponentId> componentOf_;
  std::vector<NearestNeighbours> members_;  ///< nodes of each component; empty once merged away
};

}  // namespace glissade
