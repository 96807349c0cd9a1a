#pragma once

#include <map>
#include <utility>

#include "engine/fits/fit_table.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// The shapes that the bodies of each pair are taken to have when one of them moves past the other, by the table of
/// fits. Immutable, shared by threads.
class ProductFits {
 public:
  /// By the table of this product.
  ProductFits(const AssembledProduct& product, FitTablePtr table);
  /// Finds the table, if the product's fits are on. `watch` and errors: see FitTable::find().
  static Result<ProductFits> find(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch);

  /// Fits of the body with other bodies.
  const std::vector<Fit>& fitsOf(std::size_t body) const { return table_->objects()[body].allowed; }
  /// Fits of the bodies of a group with bodies of the set outside of the group.
  std::vector<Fit> fitsOf(const BodyGroup& group, const BodySet& present) const;
  /// The body thinned by its fit with the other body; the whole body if there is none.
  const MeshPtr& meshAgainst(std::size_t body, std::size_t other) const;
  /// The shape of the other body when the body moves past it: whole, or thinned.
  const MeshPtr& obstacleFor(std::size_t body, std::size_t other) const;
  /// The clash that blocks each motion of the body past the other body; null: there is none.
  const Fit* clashOf(std::size_t body, std::size_t other) const;
  /// A fit of the two by an accepted clash: one of them is cut, or they are thinned; null: there is none.
  const Fit* acceptedClashOf(std::size_t body, std::size_t other) const;
  /// False if the time was over before the two were compared: they have no allowance against each other.
  bool areCompared(std::size_t body, std::size_t other) const;
  /// The number of pairs that were not compared.
  std::size_t notCompared() const { return table_->notCompared().size(); }
  /// The thread by which the body leaves the other body by turning only; null: they are not screwed together.
  const FitThread* threadOf(std::size_t body, std::size_t other) const;
  /// Direction in which the body leaves the other body while a hook of either bends, unit, world frame; null: none
  /// bends.
  const Vector3* bentWay(std::size_t body, std::size_t other) const;
  /// True if a body of the group leaves a body of the set outside of the group while a hook bends.
  bool isHooked(const BodyGroup& group, const BodySet& present) const;
  /// True if a body of the group is screwed together with a body of the set outside of the group.
  bool isInThread(const BodyGroup& group, const BodySet& present) const;
  /// Axes of shafts and holes that the body shares with other bodies, unit, world frame, without duplicates.
  const std::vector<Vector3>& axesOf(std::size_t body) const { return axes_[body]; }
  /// All contacts of the product; none where fits are off.
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// Clashes that nobody has accepted, each once, and bodies that cannot be thinned.
  const Warnings& warnings() const { return table_->warnings(); }
  /// The product's bodies, whole and thinned.
  const std::shared_ptr<PreparedBodies>& prepared() const { return table_->prepared(); }

 private:
  FitTablePtr table_;
  std::vector<MeshPtr> whole_;                                       ///< one entry for each body
  std::vector<std::vector<Vector3>> axes_;                           ///< one entry for each body
  std::map<std::pair<std::size_t, std::size_t>, Vector3> bentWays_;  ///< by moving body and other body
  std::vector<Contact> contacts_;
};

}  // namespace glissade
