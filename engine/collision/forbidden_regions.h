#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/environment/forbidden_places.h"
#include "engine/geometry/box_hierarchy.h"

namespace glissade {

/// A part [begin, end] of a straight motion on which the reference point is inside of a forbidden box.
struct ForbiddenStretch {
  double begin = 0.0;
  double end = 0.0;
  std::size_t place = 0;  ///< index into ForbiddenRegions::places()
};

/// Where a person forbids the object's reference point to be. Immutable, shared by threads.
class ForbiddenRegions {
 public:
  explicit ForbiddenRegions(ForbiddenPlaces places);

  const ForbiddenPlaces& places() const { return places_; }
  /// "P4, P7"
  std::string names() const;
  /// The place that the point is inside of, as an index; nothing where it is inside of none. Points of faces are not.
  std::optional<std::size_t> holding(const Vector3& p_W) const;
  /// The first box that the straight motion enters. Exact but for rounding.
  std::optional<ForbiddenStretch> firstOn(const Vector3& from_W, const Vector3& to_W) const;
  /// Some box is at most so far from the straight motion; may also be true where it is farther.
  bool mayBeWithin(double distance, const Vector3& from_W, const Vector3& to_W) const;

 private:
  ForbiddenPlaces places_;
  BoxHierarchy boxes_;
  std::vector<std::size_t> placeOf_;  ///< per box
};
using ForbiddenRegionsPtr = std::shared_ptr<const ForbiddenRegions>;

/// What is forbidden in a world at present. It changes where a person forbids a place or allows it again while a
/// planner works; queries follow at once. All functions may be called from any thread.
class ForbiddenSpace {
 public:
  /// Null: nothing is forbidden.
  void set(ForbiddenRegionsPtr regions);
  ForbiddenRegionsPtr regions() const;
  /// Grows with every set().
  std::uint64_t revision() const { return revision_.load(std::memory_order_acquire); }

 private:
  mutable std::mutex mutex_;
  ForbiddenRegionsPtr regions_;
  std::atomic<std::uint64_t> revision_{0};
};

}  // namespace glissade
