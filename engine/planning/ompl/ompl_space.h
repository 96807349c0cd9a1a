#pragma once

// Includes OMPL: for the sources of this folder only.

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <exception>
#include <mutex>
#include <optional>

#include "engine/collision/fcl_query.h"
#include "engine/planning/planner.h"
#include "engine/planning/random_shooter.h"

namespace glissade {

/// Data that OMPL's callbacks share: one planner's collision query, random numbers and limits.
struct OmplWorld {
  OmplWorld(const Problem& problem_, std::uint64_t seed);

  Problem problem;
  Se3Metric metric;
  std::unique_ptr<CollisionQuery> query;
  RandomStream stream;
  RandomShooter shooter;    ///< draws where the problem has a source
  std::uint64_t draws = 0;  ///< random configurations, kept or not
  double growthStep = 0.0;  ///< this member and the next three belong to the current piece
  double extensionStep = 0.0;
  double requiredClearance = 0.0;
  StopToken stop;
  /// Exception of the problem's source. It is kept until OMPL's planner has returned, because an exception that passes
  /// through OMPL leaks the states that the planner holds.
  std::exception_ptr sourceError;
  bool certifyEdges = false;  ///< a path has failed its certificate, so that edges are certified from now on
  std::optional<FclSurfaceQuery> surfaces;  ///< used instead of `query` where it is set
  std::uint64_t surfaceQueries = 0;

  /// True if the piece has to end: a stop is requested, or the problem's source has thrown.
  bool ends() const { return stop.stopRequested() || sourceError != nullptr; }
  /// Draws uniformly in the problem's region, or in its bounds where it has none, and in SO(3); or from its source. The
  /// result is the start where the source throws.
  Pose draw();
  /// Draws in the ball of the metric about `near` (uniform, or normal with that deviation), within the bounds. In a
  /// region the draw is repeated until it lies there; after some failures it is a configuration towards one drawn
  /// there.
  Pose drawNear(const Pose& near, double distance, bool normal);
  bool isFree(const Pose& q);
  QueryCounts queryCounts() const;
  /// Like glissade::freeFraction, but 0 where the end is out of bounds. A blocked motion ends at a multiple of the
  /// extension step, as with the engine's own planners (tolerance::kGuidedExtensionStep), because OMPL keeps such ends
  /// as nodes, and an edge that touches an obstacle cannot be certified.
  double freeFraction(const Pose& from, const Pose& to);

 private:
  Pose drawFromSource();
};

/// Mutex that is locked while OMPL's random number generators are made: their seeds come from one global generator,
/// from which another planner's thread must not draw meanwhile.
std::recursive_mutex& omplSeedMutex();

/// OMPL's SE(3) within a problem's bounds. Every state carries the number of its allocation, so that the nodes can be
/// listed in the order in which they grew.
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

/// Makes the space, its sampling and its checks. `world` must outlive the result. `attempts`: number of draws in a
/// planner's search for one free configuration.
ompl::base::SpaceInformationPtr makeSpaceInformation(OmplWorld& world, unsigned attempts);

/// Makes OMPL's own space, samplers and motion checks. Only the bounds and the collision check are the engine's.
ompl::base::SpaceInformationPtr makePlainSpaceInformation(OmplWorld& world);

}  // namespace glissade
