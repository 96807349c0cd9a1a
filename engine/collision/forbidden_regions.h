#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/collision/forbidden_motions.h"
#include "engine/geometry/box_hierarchy.h"
#include "engine/places/forbidden_places.h"

namespace glissade {

/// A part [begin, end] of a straight motion on which the reference point is within the margin of a forbidden box.
struct ForbiddenStretch {
  double begin = 0.0;
  double end = 0.0;
  std::size_t place = 0;  ///< index into ForbiddenRegions::places()
};

/// The places where a person forbids the object's reference point: closed boxes, extended by a margin along each axis.
/// Immutable, shared by threads.
class ForbiddenRegions {
 public:
  /// `margin`: metres, tolerance::kForbiddenMargin times the object's radius.
  ForbiddenRegions(ForbiddenPlaces places, double margin);

  const ForbiddenPlaces& places() const { return places_; }
  double margin() const { return margin_; }
  /// Names of the places, for example "P4, P7".
  std::string names() const;
  /// Index of the place that contains the point, or is nearer to it than the margin; nothing where there is none.
  std::optional<std::size_t> holding(const Vector3& p_W) const;
  /// True if the point is in the open interior of a box of this place.
  bool isInside(std::size_t place, const Vector3& p_W) const;
  /// The first box that the straight motion meets. Rounding makes the margin a little larger, never smaller.
  std::optional<ForbiddenStretch> firstOn(const Vector3& from_W, const Vector3& to_W) const;
  /// True if a box may be within `distance` of the straight motion. Conservative: may also be true where all are
  /// farther.
  bool mayBeWithin(double distance, const Vector3& from_W, const Vector3& to_W) const;

 private:
  ForbiddenPlaces places_;
  double margin_;
  BoxHierarchy boxes_;                ///< boxes with the margin
  std::vector<std::size_t> placeOf_;  ///< place of each box
};
using ForbiddenRegionsPtr = std::shared_ptr<const ForbiddenRegions>;

/// The forbidden regions of a world at present. They change where a person forbids a place or allows it again while a
/// planner works; queries follow at once. All functions may be called from any thread.
class ForbiddenSpace {
 public:
  /// `motions`: motions that are always forbidden; null: none.
  explicit ForbiddenSpace(std::shared_ptr<const ForbiddenMotions> motions = nullptr) : motions_(std::move(motions)) {}

  const ForbiddenMotions* motions() const { return motions_.get(); }
  /// Replaces the regions; null: nothing is forbidden.
  void set(ForbiddenRegionsPtr regions);
  ForbiddenRegionsPtr regions() const;
  /// Number that grows with every set().
  std::uint64_t revision() const { return revision_.load(std::memory_order_acquire); }

 private:
  std::shared_ptr<const ForbiddenMotions> motions_;
  mutable std::mutex mutex_;
  ForbiddenRegionsPtr regions_;
  std::atomic<std::uint64_t> revision_{0};
};

}  // namespace glissade
