#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/cut_shape.h"
#include "engine/check/evidence.h"
#include "engine/check/hollow.h"
#include "engine/check/hook.h"
#include "engine/check/placed_body.h"
#include "engine/check/product.h"

namespace glissade::check {

/// A body where it is compared with others; it may be assembled elsewhere.
struct Placement {
  const Body& body;
  Pose X_WB;
};

/// Bodies that are prepared once, and pairs that are measured once, for any number of threads. Pairs of the same two
/// meshes that are at the same pose relative to each other, to 60 picometres, are one pair.
class PlacedBodies {
 public:
  const PlacedBody& at(const Placement& placement);
  /// What the evidence gives for the two bodies, in this order. After a stop the pair is not remembered.
  PairBounds boundsOf(const Placement& one, const Placement& other, const FitWords& fits, const PairWord* word,
                      const StopToken& stop);

  /// The body without what the guest fills, in the body's frame; null where hollowed() has nothing.
  MeshPtr hollowOf(const Placement& body, const Placement& guest, const StopToken& stop);
  /// Which of the two is cut where their clash is accepted.
  Cut cutOf(const Placement& one, const Placement& other, const FitWords& fits, const StopToken& stop);

 private:
  using MeasuredPtr = std::shared_ptr<const MeasuredPair>;
  using HookPtr = std::shared_ptr<const std::vector<bool>>;
  /// The two bodies, the direction and the bend.
  using HookKey = std::tuple<const PlacedBody*, const PlacedBody*, double, double, double, double>;
  PairBounds boundsInContact(const Placement& one, const Placement& other, const FitWords& fits, const PairWord* word,
                             const StopToken& stop);
  /// A pair in the frame of its first body, which does not depend on the order in which the two are given.
  struct Ordered {
    bool isInOrder;
    const PlacedBody& first;
    const Body& secondBody;
    Pose second;
  };
  Ordered ordered(const Placement& one, const Placement& other);
  /// `otherBody`: of the other one, which is placed in the frame of the one.
  MeasuredPtr measured(const PlacedBody& one, const PlacedBody& other, const Body& otherBody, const StopToken& stop);
  void addHook(const SnapWord& snap, const Placement& hook, const Placement& edge, AllowanceBound& bound,
               const StopToken& stop);
  HookPtr measuredHook(const HookQuestion& question, const StopToken& stop);

  struct Entry {
    Pose X_WB;
    std::unique_ptr<const PlacedBody> placed;
  };
  std::mutex mutex_;
  std::map<const TriangleMesh*, std::vector<Entry>> entries_;
  std::map<std::pair<const PlacedBody*, const PlacedBody*>, MeasuredPtr> pairs_;
  std::map<HookKey, HookPtr> hooks_;
  std::map<std::pair<const PlacedBody*, const PlacedBody*>, MeshPtr> hollows_;
  std::map<std::pair<const PlacedBody*, const PlacedBody*>, CutShape> cuts_;
};

}  // namespace glissade::check
