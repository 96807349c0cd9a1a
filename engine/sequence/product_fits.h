#pragma once

#include <map>
#include <utility>

#include "engine/product/fit_table.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// A fit that a motion rests on: `body` moves past `fit.obstacle`.
struct BodyFit {
  std::size_t body = 0;
  Fit fit;
};

/// What each body of a product and each other one are taken to be when the one moves past the other, by the table of
/// fits. Immutable, shared by threads.
class ProductFits {
 public:
  /// `watch` and errors: as of FitTable::find().
  static Result<ProductFits> find(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch);

  /// Of the body with others.
  const std::vector<Fit>& fitsOf(std::size_t body) const { return moving_[body].fits; }
  /// Those of a group with bodies of the set that are not in it.
  std::vector<BodyFit> fitsOf(const BodyGroup& group, const BodySet& present) const;
  /// The body thinned as its fit with the other one allows; the body itself where there is none.
  const MeshPtr& meshAgainst(std::size_t body, std::size_t other) const;
  /// What the other one is taken to be when the body moves past it: itself, or thinner.
  const MeshPtr& obstacleFor(std::size_t body, std::size_t other) const;
  /// The clash that stops each motion of the body past the other one; null: there is none.
  const Fit* clashOf(std::size_t body, std::size_t other) const;
  /// By which the body leaves the other one by turning only; null where they are not screwed together.
  const FitThread* threadOf(std::size_t body, std::size_t other) const;
  /// The way in which the body leaves the other one while a hook of either bends, unit, world frame; null: none bends.
  const Vector3* bentWay(std::size_t body, std::size_t other) const;
  /// The group leaves bodies of the set, that are not in it, while hooks bend.
  bool isHooked(const BodyGroup& group, const BodySet& present) const;
  /// A body of the group is screwed together with one of the set that is not in the group.
  bool isInThread(const BodyGroup& group, const BodySet& present) const;
  /// Axes of shafts and holes that the body has in common with others, unit, world frame, no two alike.
  const std::vector<Vector3>& axesOf(std::size_t body) const { return moving_[body].axes; }
  /// All contacts of the product; none where fits are off.
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// Clashes that nobody accepted, each once, and bodies that cannot be thinned.
  const Warnings& warnings() const { return warnings_; }
  /// The product's bodies, with the thinned ones.
  const std::shared_ptr<PreparedBodies>& prepared() const { return prepared_; }

 private:
  struct Moving {
    std::vector<Fit> fits;
    std::vector<Vector3> axes;
    MeshPtr whole;
    std::vector<Fit> clashes{};
  };

  std::vector<Moving> moving_;                                       ///< of each body
  std::map<std::pair<std::size_t, std::size_t>, Vector3> bentWays_;  ///< of a body past another one
  std::vector<Contact> contacts_;
  Warnings warnings_;
  std::shared_ptr<PreparedBodies> prepared_;
};

}  // namespace glissade
