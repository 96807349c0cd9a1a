#include "engine/collision/forbidden_regions.h"

#include <algorithm>

namespace glissade {
namespace {

/// Relative increase of the margin above rounding, so that another computation of the margin gives the same answer.
constexpr double kRaised = 1.0 / 64.0;

Box3 grown(const Box3& box, double margin) {
  const Vector3 by = Vector3::Constant(margin);
  return {box.min() - by, box.max() + by};
}

std::vector<Box3> allBoxesOf(const ForbiddenPlaces& places, double margin) {
  std::vector<Box3> boxes;
  for (const ForbiddenPlace& place : places) {
    for (const Box3& box : place.boxes) boxes.push_back(grown(box, (1.0 + kRaised) * margin));
  }
  return boxes;
}

/// The part of the segment in the closed box, from `begin` to `end`; nothing where they do not meet.
std::optional<ForbiddenStretch> stretchIn(const Box3& box, const Vector3& from, const Vector3& to) {
  ForbiddenStretch stretch{0.0, 1.0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double way = to[axis] - from[axis];
    if (way == 0.0) {
      if (from[axis] < box.min()[axis] || from[axis] > box.max()[axis]) return std::nullopt;
      continue;
    }
    const double atMin = (box.min()[axis] - from[axis]) / way;
    const double atMax = (box.max()[axis] - from[axis]) / way;
    stretch.begin = std::max(stretch.begin, std::min(atMin, atMax));
    stretch.end = std::min(stretch.end, std::max(atMin, atMax));
  }
  return stretch.begin <= stretch.end ? std::make_optional(stretch) : std::nullopt;
}

Box3 around(const Vector3& a, const Vector3& b) { return Box3(a.cwiseMin(b), a.cwiseMax(b)); }

}  // namespace

ForbiddenRegions::ForbiddenRegions(ForbiddenPlaces places, double margin)
    : places_(std::move(places)), margin_(margin), boxes_(allBoxesOf(places_, margin)) {
  for (std::size_t place = 0; place < places_.size(); ++place) {
    placeOf_.insert(placeOf_.end(), places_[place].boxes.size(), place);
  }
}

std::string ForbiddenRegions::names() const {
  std::string all;
  for (const ForbiddenPlace& place : places_) all += (all.empty() ? "" : ", ") + place.name;
  return all;
}

std::optional<std::size_t> ForbiddenRegions::holding(const Vector3& p_W) const {
  std::optional<std::size_t> place;
  boxes_.visit(Box3(p_W, p_W), 0.0, [&](std::uint32_t box) {
    place = placeOf_[box];
    return false;
  });
  return place;
}

bool ForbiddenRegions::isInside(std::size_t place, const Vector3& p_W) const {
  const std::vector<Box3>& boxes = places_[place].boxes;
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box3& box) {
    return (p_W.array() > box.min().array()).all() && (p_W.array() < box.max().array()).all();
  });
}

std::optional<ForbiddenStretch> ForbiddenRegions::firstOn(const Vector3& from_W, const Vector3& to_W) const {
  if (from_W == to_W) {
    const auto place = holding(from_W);
    return place ? std::make_optional(ForbiddenStretch{0.0, 1.0, *place}) : std::nullopt;
  }
  std::optional<ForbiddenStretch> first;
  boxes_.visit(around(from_W, to_W), 0.0, [&](std::uint32_t box) {
    auto stretch = stretchIn(boxes_.boxes()[box], from_W, to_W);
    if (!stretch || (first && stretch->begin >= first->begin)) return true;
    stretch->place = placeOf_[box];
    first = stretch;
    return true;
  });
  return first;
}

bool ForbiddenRegions::mayBeWithin(double distance, const Vector3& from_W, const Vector3& to_W) const {
  bool near = false;
  boxes_.visit(around(from_W, to_W), distance, [&](std::uint32_t box) {
    near = stretchIn(grown(boxes_.boxes()[box], distance), from_W, to_W).has_value();
    return !near;
  });
  return near;
}

void ForbiddenSpace::set(ForbiddenRegionsPtr regions) {
  const std::lock_guard lock(mutex_);
  regions_ = std::move(regions);
  revision_.fetch_add(1, std::memory_order_release);
}

ForbiddenRegionsPtr ForbiddenSpace::regions() const {
  const std::lock_guard lock(mutex_);
  return regions_;
}

}  // namespace glissade
