#include "engine/planning/sampling_region.h"

#include <algorithm>
#include <iterator>

namespace glissade {

Vector3 SamplingRegion::sample(RandomStream& stream, const Box3& bounds) const {
  const auto count = static_cast<double>(cells_.size());
  const std::size_t i = std::min(cells_.size() - 1, static_cast<std::size_t>(stream.uniform() * count));
  const Box3 box = grid_.box(cells_[i]).intersection(bounds);
  Vector3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = stream.uniform(box.min()[axis], box.max()[axis]);
  return p;
}

bool SamplingRegion::contains(const Vector3& p_W) const {
  const auto cell = grid_.find(p_W);
  return cell && std::binary_search(cells_.begin(), cells_.end(), *cell);
}

std::vector<std::size_t> unionOf(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

}  // namespace glissade
