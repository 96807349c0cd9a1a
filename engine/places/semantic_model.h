#pragma once

#include "engine/model/body_id.h"
#include "engine/places/attribute.h"
#include "engine/places/environment_model.h"

namespace glissade {

/// Source of a value. An inherited one is set for an assembly that contains the body.
enum class Provenance { Initial, Computed, Inherited, Edited };

struct ProvenValue {
  AttributeValue value;
  Provenance provenance = Provenance::Initial;
};

/// The semantic layer: the computed attributes of places and bodies, overridden by the user's edits. An edit survives
/// recomputation because it is bound to a point of its place.
class SemanticModel {
 public:
  /// `compatibility` are the computed scores of the object, one per place; empty: not computed. Precondition:
  /// attributeTableOf(edits) succeeds. Edits of places that do not exist have no effect (see editWarnings()).
  SemanticModel(const EnvironmentModelPtr& environment, const std::vector<RigidBody>& bodies, BodyId objectId,
                const SemanticEdits& edits, const std::vector<double>& compatibility = {});

  const AttributeTable& table() const { return table_; }
  std::size_t placeCount() const { return places_.size(); }
  const std::string& placeName(std::size_t place) const { return names_[place]; }

  /// The value of an attribute of a place. Precondition: the attribute exists for places.
  ProvenValue ofPlace(std::size_t place, const std::string& attribute) const;
  ProvenValue ofBody(const BodyId& bodyId, const std::string& attribute) const;
  ProvenValue ofObject(const std::string& attribute) const { return ofBody(objectId_, attribute); }

 private:
  struct Values {
    Attributes computed;
    Attributes edited;
  };
  ProvenValue valueOf(const Values& values, AttributeOwner owner, const std::string& attribute) const;

  AttributeTable table_;
  BodyId objectId_;
  std::vector<std::string> names_;
  std::vector<Values> places_;
  std::map<std::string, Values> bodies_;
};

/// Checks edits. Refuses values of the wrong type or out of range, unknown attributes, and unknown bodies; the
/// diagnostic's location is a JSON pointer into a scenario. `ids`: ids of its bodies and assemblies.
Outcome checkEdits(const SemanticEdits& edits, const std::vector<std::string>& ids);

}  // namespace glissade
