#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A binary hierarchy of boxes, which keep their indices. Building takes microseconds per box. Immutable, shared by
/// threads.
class BoxHierarchy {
 public:
  explicit BoxHierarchy(std::vector<Box3> boxes);

  const std::vector<Box3>& boxes() const { return boxes_; }
  /// Box around all boxes; empty where there is none.
  const Box3& box() const { return box_; }

  /// Calls take(number) for every box that is at most `distance` from the given one, until it returns false.
  template <class Take>
  void visit(const Box3& near, double distance, const Take& take) const;

  /// Calls take(number) for boxes in the order of their distance from the given one, equal distances by number, up to
  /// the distance that `take` returned last; `most` at the beginning.
  template <class Take>
  void visitNearestFirst(const Box3& near, double most, const Take& take) const;

 private:
  struct Node {
    Box3 box;
    std::uint32_t first = 0;  ///< index in `order_` for a leaf, else index of the child that is not the next node
    std::uint32_t count = 0;  ///< number of a leaf's boxes; 0: no leaf
  };
  /// A node or a box to be searched. Nodes go before boxes at the same distance.
  struct Candidate {
    double squared;
    bool isBox;
    std::uint32_t number;
  };
  static bool isLater(const Candidate& a, const Candidate& b) {
    if (a.squared != b.squared) return a.squared > b.squared;
    return a.isBox != b.isBox ? a.isBox : a.number > b.number;
  }

  void build(std::uint32_t first, std::uint32_t last);

  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  Box3 box_;
};

template <class Take>
void BoxHierarchy::visit(const Box3& near, double distance, const Take& take) const {
  constexpr std::size_t kDeepest = 64;
  std::uint32_t stack[kDeepest];  // depth limit: each child has half of the boxes
  std::size_t count = 0;
  const double squared = distance * distance;
  if (!nodes_.empty()) stack[count++] = 0;
  while (count > 0) {
    const std::uint32_t at = stack[--count];
    const Node& node = nodes_[at];
    if (node.box.squaredExteriorDistance(near) > squared) continue;
    if (node.count == 0) {
      stack[count++] = node.first;
      stack[count++] = at + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (boxes_[order_[i]].squaredExteriorDistance(near) <= squared && !take(order_[i])) return;
    }
  }
}

template <class Take>
void BoxHierarchy::visitNearestFirst(const Box3& near, double most, const Take& take) const {
  std::vector<Candidate> candidates;
  const auto push = [&](const Box3& box, bool isBox, std::uint32_t number) {
    const double squared = box.squaredExteriorDistance(near);
    if (squared > most * most) return;
    candidates.push_back({squared, isBox, number});
    std::push_heap(candidates.begin(), candidates.end(), isLater);
  };
  if (!nodes_.empty()) push(box_, false, 0);
  while (!candidates.empty()) {
    const Candidate next = candidates.front();
    if (next.squared > most * most) return;
    std::pop_heap(candidates.begin(), candidates.end(), isLater);
    candidates.pop_back();
    if (next.isBox) {
      most = take(next.number);
      continue;
    }
    const Node& node = nodes_[next.number];
    if (node.count == 0) {
      push(nodes_[next.number + 1].box, false, next.number + 1);
      push(nodes_[node.first].box, false, node.first);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) push(boxes_[order_[i]], true, order_[i]);
  }
}

}  // namespace glissade
