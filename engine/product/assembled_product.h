#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/assembly/product.h"
#include "engine/check/product.h"
#include "engine/product/contact_report.h"

namespace glissade {

/// The bodies of a product where it is assembled, and what a person says of their fits. Bodies of the same geometry
/// share their mesh. Immutable while fits are found and sequences are planned.
struct AssembledProduct {
  std::vector<RigidBody> bodies;    ///< X_WB is the assembled configuration
  std::vector<double> deflections;  ///< as of ContactBody, of each body
  FitSettings fits;
  std::vector<double> spacings{};  ///< of the coordinates, metres, of each body; empty: not known
  Product tree{};                  ///< that the bodies are in; it may have others, too
  /// Hooks that a person lets bend, in sequences: there a body leaves along the way that the person says.
  std::vector<check::SnapWord> snaps{};

  /// Nothing where no body has this id.
  std::optional<std::size_t> indexOf(const std::string& id) const;
  /// What the file calls a body: its name in the tree, or its own where the tree does not hold it.
  const std::string& nameInFile(std::size_t body) const;
  double spacingOf(std::size_t body) const { return spacings.empty() ? 0.0 : spacings[body]; }
};

/// Body by body the same ids, meshes, places and fits.
bool isSameProduct(const AssembledProduct& a, const AssembledProduct& b);

/// The bodies as findContacts() takes them, in their order.
std::vector<ContactBody> contactBodiesOf(const AssembledProduct& product);

/// The same bodies, each in a frame whose origin is the middle of its bounding box; meshes that were shared still are.
std::vector<RigidBody> aboutTheirMiddles(std::vector<RigidBody> bodies);

}  // namespace glissade
