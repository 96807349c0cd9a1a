#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/made_once.h"
#include "engine/base/stop_token.h"
#include "engine/evidence/cut_shape.h"
#include "engine/evidence/evidence.h"
#include "engine/evidence/hollow.h"
#include "engine/evidence/hook.h"
#include "engine/evidence/pair_words.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// A body at the pose in which it is compared with others; it may be assembled elsewhere.
struct Placement {
  const Body& body;
  Pose X_WB;
};

/// Prepares bodies once and measures pairs once. Thread-safe. Pairs of the same two meshes at the same relative pose,
/// to 60 picometres, are one pair.
class PlacedBodies {
 public:
  const PlacedBody& at(const Placement& placement);
  /// Measures the pair for a later question.
  void measure(const Placement& one, const Placement& other, const StopToken& stop);
  /// The allowances that the evidence gives for the two bodies, in this order. After a stop the pair is not stored.
  PairBounds boundsOf(const Placement& one, const Placement& other, const FitWords& fits, const PairWord* word,
                      const StopToken& stop);

  /// The body without the volume that the guest fills, in the body's frame; null if hollowed() gives nothing.
  MeshPtr hollowOf(const Placement& body, const Placement& guest, const StopToken& stop);
  /// The body that is cut if their clash is accepted. Where it is not clear and clashes are accepted as advised, it is
  /// the smaller one that stays whole.
  Cut cutOf(const Placement& one, const Placement& other, const FitWords& fits, const StopToken& stop);

 private:
  using MeasuredPtr = std::shared_ptr<const MeasuredPair>;
  using HookPtr = std::shared_ptr<const std::vector<bool>>;
  /// The two bodies, the direction and the bend.
  using HookKey = std::tuple<const PlacedBody*, const PlacedBody*, double, double, double, double>;
  PairBounds boundsInContact(const Placement& one, const Placement& other, const FitWords& fits, const PairWord* word,
                             const StopToken& stop);
  /// A pair in the frame of its first body, whichever order the two were given in.
  struct Ordered {
    bool isInOrder;
    const PlacedBody& first;
    const Body& secondBody;
    Pose second;
  };
  /// Measurements of a pair, and its second body where it was measured. Null: the bodies are apart.
  struct MeasuredHere {
    const PlacedBody* second = nullptr;
    MeasuredPtr pair{};
  };
  Ordered ordered(const Placement& one, const Placement& other);
  MeasuredHere measured(const Ordered& pair, const StopToken& stop);
  void addHook(const SnapWord& snap, const Placement& hook, const Placement& edge, AllowanceBound& bound,
               const StopToken& stop);
  HookPtr measuredHook(const HookQuestion& question, const StopToken& stop);

  struct Entry {
    Pose X_WB;
    std::unique_ptr<const PlacedBody> placed;
  };
  using PairKey = std::pair<const PlacedBody*, const PlacedBody*>;
  std::mutex mutex_;  ///< guards entries_
  std::map<const TriangleMesh*, std::vector<Entry>> entries_;
  MadeOnce<PairKey, MeasuredPtr> pairs_;
  MadeOnce<HookKey, HookPtr> hooks_;
  MadeOnce<PairKey, MeshPtr> hollows_;
  MadeOnce<PairKey, CutShape> cuts_;
};

}  // namespace glissade::evidence
