#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/evidence/body.h"
#include "engine/evidence/pair_words.h"
#include "engine/fits/contact_report.h"
#include "engine/model/body_id.h"
#include "engine/model/product.h"

namespace glissade {

/// The assembled bodies of a product, and a person's statements about their fits. Bodies of the same geometry share
/// their mesh. Immutable while fits are found and sequences are planned.
struct AssembledProduct {
  std::vector<RigidBody> bodies;    ///< X_WB is the assembled configuration
  std::vector<double> deflections;  ///< see ContactBody::deflection; one entry for each body
  FitSettings fits;
  std::vector<double> spacings{};  ///< spacing of the coordinates of each body, metres; empty: not known
  Product tree{};                  ///< tree that contains the bodies; it may contain others, too
  /// Hooks that a person permits to bend in sequences: the body leaves in the stated direction.
  std::vector<evidence::SnapWord> snaps{};

  /// Index of the body with an id that a file, a person or another revision gives; nothing: no body has it.
  std::optional<std::size_t> find(const BodyId& id) const;
  /// The index of each body, to find many of such ids.
  std::map<BodyId, std::size_t> indicesById() const;
  /// Index of the body with the id. Precondition: a body has it.
  std::size_t indexOf(const BodyId& id) const;
  /// The indices of the bodies with these ids, in their order. Precondition: bodies have them.
  std::vector<std::size_t> indicesOf(const std::vector<BodyId>& ids) const;
  /// The body with the id. Precondition: a body has it.
  const RigidBody& body(const BodyId& id) const { return bodies[indexOf(id)]; }
  /// Name of the body in the file: its name in the tree, or the body's name if the tree does not contain it.
  const std::string& nameInFile(std::size_t body) const;
  /// The body as the judge measures it.
  evidence::Body measured(std::size_t body) const;
  double spacingOf(std::size_t body) const { return spacings.empty() ? 0.0 : spacings[body]; }
};

/// True if all bodies have the same ids, meshes and poses, and the fits are equal.
bool isSameProduct(const AssembledProduct& a, const AssembledProduct& b);

/// The bodies as findContacts() expects them, in their order.
std::vector<ContactBody> contactBodiesOf(const AssembledProduct& product);

/// The bodies with frames at the centres of their bounding boxes; meshes stay shared.
std::vector<RigidBody> aboutTheirMiddles(std::vector<RigidBody> bodies);

}  // namespace glissade
