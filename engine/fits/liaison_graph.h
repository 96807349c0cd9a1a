#pragma once

#include <vector>

#include "engine/fits/contact_report.h"
#include "engine/fits/joint.h"

namespace glissade {

/// An edge of the liaison graph: the contact and the joints that hold two bodies of an assembled product to each other.
struct Liaison {
  std::size_t a = 0;  ///< index of the body, below `b`
  std::size_t b = 0;
  std::optional<ContactKind> contact{};  ///< how they touch or overlap; nothing if they do not
  std::vector<JointKind> joints{};       ///< joints of which both are bodies, without duplicates
  /// Directions in which a joint or a common axis lets `b` leave `a`, unit, world frame. A joint names one sense, a
  /// common axis both. Empty: the liaison has no axis.
  std::vector<Vector3> lettingGo{};
};

/// The bodies of a product as nodes, and what holds them to each other as edges (liaison graph: De Fazio and Whitney
/// 1987). Immutable, shared by threads.
class LiaisonGraph {
 public:
  LiaisonGraph(std::size_t bodies, const std::vector<Contact>& contacts, const Joints& joints);

  /// All edges, ordered by a, then by b.
  const std::vector<Liaison>& liaisons() const { return liaisons_; }
  /// Bodies that touch the body or are joined to it, ascending.
  const std::vector<std::size_t>& neighboursOf(std::size_t body) const { return neighbours_[body]; }
  /// Clusters: the largest groups of bodies that joints connect, directly or through others, each of two bodies or
  /// more; ascending. A flexible body connects nothing.
  std::vector<std::vector<std::size_t>> clusters() const;

 private:
  std::vector<Liaison> liaisons_;
  std::vector<std::vector<std::size_t>> neighbours_;
};

}  // namespace glissade
