#pragma once

#include "engine/base/thread_team.h"
#include "engine/product/object_fits.h"
#include "engine/sequence/assembled_product.h"

namespace glissade {

/// A fit that a motion rests on: `body` moves past `fit.obstacle`, an index in the product.
struct BodyFit {
  std::size_t body = 0;
  Fit fit;
  bool yields = false;  ///< the obstacle is taken thinner, not the body
};

/// What each body of a product and each other one are taken to be when the one moves past the other. Immutable, shared
/// by threads.
class ProductFits {
 public:
  /// Compares each pair of bodies once. Errors: as of findObjectFits(); Interrupted.
  static Result<ProductFits> find(const AssembledProduct& product, ThreadTeam& team, const StopToken& stop);

  /// Of the body with others; `obstacle` is an index in the product.
  const std::vector<Fit>& fitsOf(std::size_t body) const { return moving_[body].allowed; }
  /// Those of a group with bodies of the set that are not in it, also those where the other one yields.
  std::vector<BodyFit> fitsOf(const BodyGroup& group, const BodySet& present) const;
  /// The body thinned as its fit with the other one allows; the body itself where there is none.
  const MeshPtr& meshAgainst(std::size_t body, std::size_t other) const;
  /// Fits of the body where the other one is taken thinner: instead of the body, because that has no place for the
  /// allowance, or as the body, because neither has place for all of it. `obstacle` is the other one, the role is the
  /// body's.
  const std::vector<Fit>& yieldingTo(std::size_t body) const { return moving_[body].yielding; }
  /// What the other one is taken to be when the body moves past it: itself, or thinner.
  const MeshPtr& obstacleFor(std::size_t body, std::size_t other) const;
  /// By which the body leaves the other one by turning only, in whichever of the two the fit is allowed; null where
  /// they are not screwed together. Its obstacle is the index in the product.
  const FitThread* threadOf(std::size_t body, std::size_t other) const;
  /// A body of the group is screwed together with one of the set that is not in the group.
  bool isInThread(const BodyGroup& group, const BodySet& present) const;
  /// Axes of shafts and holes that the body has in common with others, unit, world frame, no two alike.
  const std::vector<Vector3>& axesOf(std::size_t body) const { return moving_[body].axes; }
  /// All contacts of the product; none where fits are off.
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// Clashes that nobody accepted, each once, and bodies that cannot be thinned.
  const Warnings& warnings() const { return warnings_; }

 private:
  struct Moving {
    std::vector<Fit> allowed;
    std::vector<Fit> yielding;  ///< `thinned` is the other one
    std::vector<Vector3> axes;
    MeshPtr whole;
  };

  void resolveClashes(const AssembledProduct& product, const std::vector<Result<ObjectFits>>& fits, ThreadTeam& team);

  std::vector<Moving> moving_;  ///< of each body
  std::vector<Contact> contacts_;
  Warnings warnings_;
};

/// The fits of one body with bodies of the product. `contacts`: of the product, where they are known; or null.
/// `placed`: bodies that were prepared, or null. Errors: as of findObjectFits().
Result<ObjectFits> fitsOfBody(const AssembledProduct& product, std::size_t body, const ContactReport* contacts,
                              const StopToken& stop, check::PlacedBodies* placed = nullptr);

}  // namespace glissade
