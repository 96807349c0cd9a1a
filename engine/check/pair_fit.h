#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/check/evidence_names.h"
#include "engine/check/path.h"
#include "engine/evidence/evidence.h"
#include "engine/evidence/named_screw.h"
#include "engine/evidence/placed_bodies.h"
#include "engine/evidence/thread.h"
#include "engine/evidence/thread_core.h"
#include "engine/model/body_id.h"

namespace glissade::check {

/// An allowance as a judgement applied it.
struct AppliedAllowance {
  BodyId moving;  ///< id of the moving body
  BodyId other;
  std::string thinner;  ///< name of the thinned body, for people
  std::string against;
  bool yields = false;             ///< the other body is taken thinner
  bool core = false;               ///< the thread of the body is taken away
  bool hollow = false;             ///< the volume that the other body fills is taken away; `applied` is its depth
  bool screwHole = false;          ///< the other body is a screw for which the file has no hole
  std::optional<double> stated{};  ///< metres, as the file states it
  double applied = 0.0;            ///< metres, at the face that moves farthest
  double most = 0.0;               ///< metres that the meshes and the person permit
  Evidence evidence{};             ///< evidence for `most`
  std::optional<Thread> thread{};
  double plainOverlap = 0.0;  ///< metres: depth of the pair if PairBounds::isPlainOverlap
  double bend = 0.0;          ///< bend of the thinner body's hook that a person states, metres; 0: no hook
};

/// The shapes of the two bodies of a pair while one moves past the other.
struct PairFit {
  /// Allowance of each triangle of the moving body, for AllowanceBound::mesh; empty: the body is whole.
  std::vector<double> moving{};
  std::vector<double> other{};
  MeshPtr meshOfMoving{};  ///< AllowanceBound::mesh
  MeshPtr meshOfOther{};
  MeshPtr hollowMoving{};  ///< mesh without the volume that the other body fills; null: the body is not hollow
  MeshPtr hollowOther{};
  double depth = 0.0;                     ///< PairBounds::depth, metres
  std::optional<ScrewInSolid> inSolid{};  ///< set if one body is a screw that makes its hole in the other
  bool acceptedClash = false;             ///< one body is hollow, and the pair would be refused without acceptance
  double share = kThicknessShare;         ///< see AllowanceBound::share; the larger one of the two
  std::optional<Thread> thread{};         ///< `other` is left to the caller
  /// Core of the shaft of the thread, in its frame; nothing: no thread is taken away.
  std::optional<ThreadCore> core{};
  std::vector<AppliedAllowance> applied{};
  std::vector<Message> refusals{};  ///< errors for people; empty: none

  bool isThinned() const { return !moving.empty() || !other.empty() || core || hollowMoving || hollowOther; }
  /// Null: the body's thread is kept.
  const ThreadCore* coreOfMoving() const { return core && thread->movingIsShaft ? &*core : nullptr; }
  const ThreadCore* coreOfOther() const { return core && !thread->movingIsShaft ? &*core : nullptr; }
};

/// The input for the fit of a pair.
struct PairQuestion {
  const Body& moving;
  const Body& other;
  std::vector<Pose> assembled;                                ///< configurations of the moving body
  const std::optional<std::vector<StatedAllowance>>& stated;  ///< statements of the path or the step
  BodyId first;                                               ///< id of the moving body for allowances that name none
  std::vector<Pose> path;                                     ///< configurations of the moving body
};

/// Takes the pair as the file states it, as far as the meshes and a person's statements permit. If the format of the
/// file has no allowances, the permitted ones are applied: to the moving body if that is enough, else to the other
/// body, else to both.
PairFit fitOf(const PairQuestion& question, const FitWords& fits, PlacedBodies& bodies, const StopToken& stop);

}  // namespace glissade::check
