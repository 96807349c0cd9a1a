#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/check/placed_bodies.h"
#include "engine/collision/prepared_bodies.h"
#include "engine/product/assembled_product.h"
#include "engine/product/core_fit.h"
#include "engine/product/fit.h"
#include "engine/product/thinnable_bodies.h"

namespace glissade {

/// What becomes of the pairs of the object with the bodies that it touches.
struct ObjectFits {
  std::vector<Fit> allowed;       ///< by obstacle; two of one obstacle where both bodies are taken thinner
  std::vector<Fit> clashes;       ///< pairs that no motion of the object passes, by obstacle: both bodies are whole
  std::vector<Contact> contacts;  ///< by obstacle, which is `a`; with the kinds and overlaps that count
  Warnings warnings;              ///< one for each clash
};

/// What was prepared of the bodies of a product; for any number of threads.
struct FitTools {
  check::PlacedBodies placed;
  ThinnableBodies thinnable;
  ModelledPitches pitches;
  std::shared_ptr<PreparedBodies> prepared{};  ///< of the product's bodies; null: there are none
};

/// What is asked about the fits of one body of a product, while it moves.
struct FitQuestion {
  const AssembledProduct& product;
  std::size_t object;        ///< the body that moves
  std::vector<Pose> ends{};  ///< configurations in which the product may be assembled; empty: where the object is
  const std::vector<Contact>* contacts = nullptr;  ///< of the product, where they are known
  ContactLimits limits{};                          ///< that contacts are found with
  /// A world with the other bodies as obstacles: what it has prepared is not prepared again. Null: there is none.
  CollisionWorldPtr world{};
  FitTools* tools = nullptr;  ///< null: there are none
};

/// The fits of the object with all bodies that it touches at one of the ends. Nothing is allowed for others.
///
/// The smaller body of the pair is taken thinner; where it has no place for that, the other one; where neither has
/// place for all of it, both. A face is taken thinner by no more than the evidence for it (check::boundsOf()): the
/// overlap as measured, the deflections and the coordinate spacing that the files state, assembledGap(), and what a
/// person says; by less where the body has no place for that and less is enough. A clash is allowed where it is
/// accepted. Where no allowance makes the pair free at the ends, the pair is a clash. A pair that is marked as a thread
/// is one although it does not touch.
///
/// Errors: MalformedInput with "/fits/pairs/<index>" as place: a body that is not there, an allowance above what the
/// thickness of both bodies can give, an allowance for a pair that does not touch, a thread without a common axis.
/// After a stop the fits are incomplete.
Result<ObjectFits> findObjectFits(const FitQuestion& question, const StopToken& stop = {});

/// What an allowance leaves between two bodies that touch, metres: a micrometre, or four of the clearances that a path
/// has to keep for an object of this radius, if that is more.
double assembledGap(double objectRadius);

}  // namespace glissade
