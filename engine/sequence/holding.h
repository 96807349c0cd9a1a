#pragma once

#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Contacts, fits and joints that hold the bodies of a product after some steps of a plan have been carried out.
/// Immutable.
class Holding {
 public:
  explicit Holding(const SequenceQuestion& question);

  /// True if no chain of contacts and joints between bodies of `remaining` holds the group to the base. In assembly,
  /// such a group is put into the air. Always false where contacts are not known.
  bool isInAir(const BodyGroup& group, const BodySet& remaining) const;
  /// The bodies of `there` that touch others or are joined to others, and that no chain of contacts and joints between
  /// bodies of `there` holds to the base. Precondition: contacts are known.
  BodySet floating(const BodySet& there) const;
  /// The bodies of the set, divided into parts that touch each other or are joined; ascending.
  std::vector<BodyGroup> connectedParts(const BodySet& set) const;
  /// Number of bodies of `remaining` that screws, nuts, threads and pins joined to the base at the beginning, directly
  /// or through others, and no longer do.
  std::size_t unfastened(const BodySet& remaining) const;
  /// Number of fastener stacks (JointRules::stacks()) of which some bodies have left and others remain.
  std::size_t openStacks(const BodySet& remaining) const;

 private:
  BodySet joinedToBase(const BodySet& there) const;
  BodySet reachedFrom(const BodyGroup& from, const BodySet& there) const;

  const SequenceQuestion& question_;
  BodySet initial_;                      ///< bodies that are there at the beginning
  std::vector<const Joint*> fastening_;  ///< screws, nuts, threads and pins
  BodyGroup joined_;                     ///< bodies that are joined to the base at the beginning
};

}  // namespace glissade
