#pragma once

// Includes OMPL: for the sources of this folder only.

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <mutex>
#include <optional>

#include "engine/collision/fcl_query.h"
#include "engine/planning/planner.h"

namespace glissade {

/// What OMPL's callbacks share: one planner's collision query, random numbers and limits.
struct OmplWorld {
  OmplWorld(const Problem& problem_, std::uint64_t seed);

  Problem problem;
  Se3Metric metric;
  std::unique_ptr<CollisionQuery> query;
  RandomStream stream;
  std::uint64_t draws = 0;  ///< random configurations, kept or not
  double growthStep = 0.0;  ///< this and the next three: of the piece under way
  double extensionStep = 0.0;
  double requiredClearance = 0.0;
  StopToken stop;
  bool certifyEdges = false;                ///< a path has failed its certificate: from now on edges are certified
  std::optional<FclSurfaceQuery> surfaces;  ///< where it is there, it is asked instead of `query`
  std::uint64_t surfaceQueries = 0;

  /// Uniform in the problem's region, or its bounds where it has none, and in SO(3).
  Pose draw();
  /// In the ball of the metric about `near` (uniform, or normal with that deviation), within the
  /// bounds. In a region the draw is repeated until it lies there; after some failures it is a
  /// configuration towards one drawn there.
  Pose drawNear(const Pose& near, double distance, bool normal);
  bool isFree(const Pose& q);
  QueryCounts queryCounts() const;
  /// As glissade::freeFraction, but 0 where the end is out of bounds, and a blocked motion ends at a
  /// multiple of the extension step, as our own planners' (tolerance::kGuidedExtensionStep): OMPL
  /// keeps such ends as nodes, and nothing that touches an obstacle can be certified.
  double freeFraction(const Pose& from, const Pose& to);
};

/// Taken while OMPL's random number generators are made: their seeds come from one global generator,
/// which another planner's thread must not draw from in between.
std::recursive_mutex& omplSeedMutex();

/// OMPL's SE(3) within a problem's bounds. Every state carries the number of its allocation, so that
/// what a planner grew can be listed in the order in which it grew.
class SerialSpace : public ompl::base::SE3StateSpace {
 public:
  explicit SerialSpace(const Problem& problem);

  static Pose poseOf(const ompl::base::State* state);
  static void setPose(ompl::base::State* state, const Pose& q);
  static std::uint64_t serialOf(const ompl::base::State* state);

  ompl::base::State* allocState() const override;

 private:
  mutable std::uint64_t allocated_ = 0;
};

/// SE(3) with our metric and our interpolation (OMPL's own distance is |dp| + weight * angle / 2,
/// which weights cannot turn into ours).
class OmplSpace final : public SerialSpace {
 public:
  explicit OmplSpace(const Problem& problem);

  double distance(const ompl::base::State* a, const ompl::base::State* b) const override;
  double getMaximumExtent() const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  bool satisfiesBounds(const ompl::base::State* state) const override;

 private:
  Box3 bounds_;
  Se3Metric metric_;
};

/// Space, sampling and checks put together. `world` must outlive what is returned.
/// `attempts`: draws that a planner's search for one free configuration may take.
ompl::base::SpaceInformationPtr makeSpaceInformation(OmplWorld& world, unsigned attempts);

/// OMPL's own space, samplers and motion checks; ours are only the bounds and the collision check.
ompl::base::SpaceInformationPtr makePlainSpaceInformation(OmplWorld& world);

}  // namespace glissade
