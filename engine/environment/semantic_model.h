#pragma once

#include "engine/environment/attribute.h"
#include "engine/environment/environment_model.h"

namespace glissade {

/// Where a value comes from; inherited ones are said of an assembly that the body is in.
enum class Provenance { Initial, Computed, Inherited, Edited };

struct ProvenValue {
  AttributeValue value;
  Provenance provenance = Provenance::Initial;
};

/// The semantic layer: what is computed on the places and bodies, with the user's edits over it. An
/// edit survives recomputation because it is bound to a point of its place.
class SemanticModel {
 public:
  /// `compatibility` are the computed scores of the object, per place; empty: not computed.
  /// Precondition: attributeTableOf(edits) succeeds. Edits of places that are nowhere count for
  /// nothing (editWarnings() tells of them).
  SemanticModel(const EnvironmentModelPtr& environment, const std::vector<RigidBody>& bodies, std::string objectId,
                const SemanticEdits& edits, const std::vector<double>& compatibility = {});

  const AttributeTable& table() const { return table_; }
  std::size_t placeCount() const { return places_.size(); }
  const std::string& placeName(std::size_t place) const { return names_[place]; }

  /// Precondition: the attribute exists for that owner.
  ProvenValue ofPlace(std::size_t place, const std::string& attribute) const;
  ProvenValue ofBody(const std::string& bodyId, const std::string& attribute) const;
  ProvenValue ofObject(const std::string& attribute) const { return ofBody(objectId_, attribute); }

 private:
  struct Values {
    Attributes computed;
    Attributes edited;
  };
  ProvenValue valueOf(const Values& values, AttributeOwner owner, const std::string& attribute) const;

  AttributeTable table_;
  std::string objectId_;
  std::vector<std::string> names_;
  std::vector<Values> places_;
  std::map<std::string, Values> bodies_;
};

/// Refuses edits with values of the wrong type or out of range, unknown attributes, and unknown
/// bodies; the diagnostic's place is a JSON pointer into a scenario. `ids`: of its bodies and assemblies.
Outcome checkEdits(const SemanticEdits& edits, const std::vector<std::string>& ids);

}  // namespace glissade
