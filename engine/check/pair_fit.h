#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/check/evidence.h"
#include "engine/check/named_screw.h"
#include "engine/check/path.h"
#include "engine/check/placed_bodies.h"
#include "engine/check/thread.h"
#include "engine/check/thread_core.h"

namespace glissade::check {

/// An allowance as it was applied in a judgement.
struct AppliedAllowance {
  std::string moving;  ///< ids
  std::string other;
  std::string thinner;  ///< names, for people: of the body that is taken thinner
  std::string against;
  bool yields = false;             ///< the other one is taken thinner
  bool core = false;               ///< its thread is taken away
  bool hollow = false;             ///< what the other one fills is taken away; `applied` is its depth
  bool screwHole = false;          ///< the other one is a screw, for which the file has no hole
  std::optional<double> stated{};  ///< metres, by the file
  double applied = 0.0;            ///< metres, of the face that moves farthest
  double most = 0.0;               ///< metres that the meshes and the person give
  Evidence evidence{};             ///< for that
  std::optional<Thread> thread{};
  double plainOverlap = 0.0;  ///< metres: depth of the pair, where PairBounds::isPlainOverlap
  double bend = 0.0;  ///< metres, by which a person says that the hook of the thinner body bends; 0: it has none
};

/// How the two bodies of a pair are taken while the one moves past the other.
struct PairFit {
  /// Allowance of each triangle of the moving one, as AllowanceBound::mesh has them; empty: it is whole.
  std::vector<double> moving{};
  std::vector<double> other{};
  MeshPtr meshOfMoving{};  ///< AllowanceBound::mesh
  MeshPtr meshOfOther{};
  MeshPtr hollowMoving{};  ///< without what the other one fills; null: it is not hollow
  MeshPtr hollowOther{};
  double depth = 0.0;                     ///< metres: PairBounds::depth
  std::optional<ScrewInSolid> inSolid{};  ///< one is hollow because the other one is a screw that makes its hole
  bool acceptedClash = false;             ///< one is hollow, and the pair would be refused if nobody accepted it
  double share = kThicknessShare;         ///< as AllowanceBound::share, of either
  std::optional<Thread> thread{};         ///< its `other` is left to the caller
  /// Of the shaft of the thread, in its frame; nothing: no thread is taken away.
  std::optional<ThreadCore> core{};
  std::vector<AppliedAllowance> applied{};
  std::vector<std::string> refusals{};  ///< for people; empty: nothing is wrong

  bool isThinned() const { return !moving.empty() || !other.empty() || core || hollowMoving || hollowOther; }
  /// Null: the body's thread is not taken away.
  const ThreadCore* coreOfMoving() const { return core && thread->movingIsShaft ? &*core : nullptr; }
  const ThreadCore* coreOfOther() const { return core && !thread->movingIsShaft ? &*core : nullptr; }
};

/// What is asked about a pair.
struct PairQuestion {
  const Body& moving;
  const Body& other;
  std::vector<Pose> assembled;                                ///< configurations of the moving one
  const std::optional<std::vector<StatedAllowance>>& stated;  ///< of the path or the step
  std::string first;                                          ///< id of who moves where an allowance names nobody
  std::vector<Pose> path;                                     ///< of the moving body
};

/// Takes the pair as the file says, as far as the meshes and the person's words bear it. Where the file states nothing
/// because its format cannot, what these bear is applied: to the moving body where it has room for that, else to the
/// other one, else to both.
PairFit fitOf(const PairQuestion& question, const FitWords& fits, PlacedBodies& bodies, const StopToken& stop);

}  // namespace glissade::check
