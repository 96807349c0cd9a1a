#include "engine/geometry/box_hierarchy.h"

#include <numeric>
#include <utility>

namespace glissade {
namespace {

constexpr std::uint32_t kMostBoxesInALeaf = 4;

}  // namespace

BoxHierarchy::BoxHierarchy(std::vector<Box3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  for (const Box3& box : boxes_) box_.extend(box);
  if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

void BoxHierarchy::build(std::uint32_t first, std::uint32_t last) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  Box3 box;
  Box3 centres;
  for (std::uint32_t i = first; i < last; ++i) {
    box.extend(boxes_[order_[i]]);
    centres.extend(boxes_[order_[i]].center());
  }
  nodes_[at].box = box;
  if (last - first <= kMostBoxesInALeaf) {
    nodes_[at].first = first;
    nodes_[at].count = last - first;
    return;
  }
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const auto begin = order_.begin() + first;
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(begin, order_.begin() + middle, order_.begin() + last, [&](std::uint32_t a, std::uint32_t b) {
    const double centreA = boxes_[a].center()[axis];
    const double centreB = boxes_[b].center()[axis];
    return centreA != centreB ? centreA < centreB : a < b;
  });
  build(first, middle);
  nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
  build(middle, last);
}

}  // namespace glissade
