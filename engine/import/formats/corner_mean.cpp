#include "engine/import/formats/corner_mean.h"

#include <limits>

namespace glissade {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr float kEqual = 1e-5F;
/// Number of corners at one position that are compared with a new one; limits the time for the tip of a cone.
constexpr int kMostCompared = 1000;

}  // namespace

bool CornerMean::isKnown(std::uint32_t vertex, const CornerAttributes& attributes) const {
  std::uint32_t at = newest_[vertex];
  for (int i = 0; at != kNone && i < kMostCompared; ++i) {
    const Corner& corner = corners_[at];
    if (corner.section != section_) return false;
    if ((corner.attributes.normal - attributes.normal).squaredNorm() <= kEqual * kEqual &&
        (corner.attributes.texture - attributes.texture).squaredNorm() <= kEqual * kEqual) {
      return true;
    }
    at = corner.previous;
  }
  return false;
}

void CornerMean::add(std::uint32_t vertex, const Vector3& position, const CornerAttributes& attributes) {
  if (vertex >= newest_.size()) newest_.resize(vertex + 1, kNone);
  if (isKnown(vertex, attributes)) return;
  corners_.push_back({attributes, section_, newest_[vertex]});
  newest_[vertex] = static_cast<std::uint32_t>(corners_.size() - 1);
  sum_ += position.cast<float>();
}

Vector3 CornerMean::mean() const {
  if (corners_.empty()) return Vector3::Zero();
  return (sum_ / static_cast<float>(corners_.size())).cast<double>();
}

}  // namespace glissade
