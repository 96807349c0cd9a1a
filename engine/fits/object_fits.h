#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/collision/prepared_bodies.h"
#include "engine/evidence/placed_bodies.h"
#include "engine/fits/assembled_product.h"
#include "engine/fits/core_fit.h"
#include "engine/fits/fit.h"
#include "engine/fits/thinnable_bodies.h"

namespace glissade {

/// The fits of the object with the bodies that it touches.
struct ObjectFits {
  std::vector<Fit> allowed;       ///< ordered by obstacle; two for one obstacle if both bodies are thinned
  std::vector<Fit> clashes;       ///< pairs that block every motion of the object, ordered by obstacle
  std::vector<Contact> contacts;  ///< ordered by obstacle, which is `a`; with the kinds and overlaps that count
  Warnings warnings;              ///< one for each clash
};

/// Prepared data of a product's bodies. Thread-safe.
struct FitTools {
  evidence::PlacedBodies placed;
  ThinnableBodies thinnable;
  ModelledPitches pitches;
  std::shared_ptr<PreparedBodies> prepared{};  ///< collision bodies of the product; null: there are none
};

/// The input for the fits of a moving body of a product.
struct FitQuestion {
  const AssembledProduct& product;
  std::size_t object;        ///< the moving body
  std::vector<Pose> ends{};  ///< configurations in which the product may be assembled; empty: the object's pose
  const std::vector<Contact>* contacts = nullptr;  ///< contacts of the product; null: not known
  ContactLimits limits{};                          ///< limits for finding contacts
  /// A world with the other bodies as obstacles, whose prepared data are reused. Null: there is none.
  CollisionWorldPtr world{};
  FitTools* tools = nullptr;  ///< null: there are none
};

/// The fits of the object with all bodies that it touches at one of the ends; other bodies get no allowance.
///
/// The smaller body of the pair is thinned; if it has no room, the other body; if neither has enough room, both. A face
/// is thinned by no more than its evidence (evidence::boundsOf()): the measured overlap, the deflections and the
/// coordinate spacing that the files state, assembledGap(), and a person's allowance. It is thinned by less if the body
/// has less room and less is enough. An accepted clash is allowed. If no allowance makes the pair free at the ends, the
/// pair is a clash. A pair that is marked as a thread need not touch.
///
/// Errors: MalformedInput with "/fits/pairs/<index>" as place: a body that does not exist, an allowance above the limit
/// of the thickness of both bodies, an allowance for a pair that does not touch, a thread without a common axis. After
/// a stop the fits are incomplete.
Result<ObjectFits> findObjectFits(const FitQuestion& question, const StopToken& stop = {});

/// The gap that an allowance leaves between two bodies that touch, metres: a micrometre, or four times the clearance
/// that a path has to keep for an object of this radius if that is more.
double assembledGap(double objectRadius);

}  // namespace glissade
