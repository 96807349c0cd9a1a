#include "engine/places/semantic_model.h"

#include <set>

#include "engine/places/edit_binding.h"

namespace glissade {

SemanticModel::SemanticModel(const EnvironmentModelPtr& environment, const std::vector<RigidBody>& bodies,
                             BodyId objectId, const SemanticEdits& edits, const std::vector<double>& compatibility)
    : objectId_(std::move(objectId)) {
  if (auto table = attributeTableOf(edits)) table_ = std::move(*table);
  const TopologicalMap& map = environment->map;
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    const Place& place = map.places[i];
    Values values;
    values.computed["complexity"] = static_cast<double>(place.complexity);
    values.computed["narrowness"] = place.narrowness;
    values.computed["cluttered"] = static_cast<bool>(environment->cluttered[i]);
    if (i < compatibility.size()) values.computed["compatibility"] = compatibility[i];
    places_.push_back(std::move(values));
    names_.push_back(place.name);
  }
  for (const RigidBody& body : bodies) {
    bodies_[body.id.text()].computed["mobility"] = std::string(kMobilityNames.of(body.mobility));
  }
  bodies_[objectId_.text()].computed["mobility"] = std::string("mobile");
  for (const PlaceEdit& edit : edits.places) {
    const int place = boundPlace(map, edit.at);
    if (place == kNoPlace) continue;
    const auto p = static_cast<std::size_t>(place);
    if (!edit.name.empty()) names_[p] = edit.name;
    for (const auto& [name, value] : edit.attributes) places_[p].edited[name] = value;
  }
  for (const auto& [id, attributes] : edits.bodies) {
    for (const auto& [name, value] : attributes) bodies_[id].edited[name] = value;
  }
}

ProvenValue SemanticModel::valueOf(const Values& values, AttributeOwner owner, const std::string& attribute) const {
  const auto edited = values.edited.find(attribute);
  if (edited != values.edited.end()) return {edited->second, Provenance::Edited};
  const auto computed = values.computed.find(attribute);
  if (computed != values.computed.end()) return {computed->second, Provenance::Computed};
  return {table_.find(owner, attribute)->initial, Provenance::Initial};
}

ProvenValue SemanticModel::ofPlace(std::size_t place, const std::string& attribute) const {
  return valueOf(places_[place], AttributeOwner::Place, attribute);
}

ProvenValue SemanticModel::ofBody(const BodyId& bodyId, const std::string& attribute) const {
  const auto valuesOf = [&](const BodyId& id) {
    const auto known = bodies_.find(id.text());
    return known == bodies_.end() ? Values{} : known->second;
  };
  Values values = valuesOf(bodyId);
  // A link of a URDF file has the attributes of its body, unless it has its own.
  const BodyId whole = bodyIdOf(bodyId);
  if (whole != bodyId) values.edited.merge(valuesOf(whole).edited);
  return valueOf(values, AttributeOwner::Body, attribute);
}

namespace {

Outcome checkAttributes(const AttributeTable& table, AttributeOwner owner, const Attributes& attributes,
                        const std::string& pointer) {
  for (const auto& [name, value] : attributes) {
    const AttributeDefinition* definition = table.find(owner, name);
    if (definition == nullptr) {
      return Diagnostic{ErrorKind::MalformedInput, "", pointer + "/" + name,
                        GLISSADE_TEXT("is not a defined attribute"),
                        GLISSADE_TEXT("Define it under /attributes, or remove it.")};
    }
    const Outcome sound = checkValue(*definition, value);
    if (sound) continue;
    Diagnostic why = sound.error();
    why.location = pointer + "/" + name;
    return why;
  }
  return Done{};
}

}  // namespace

Outcome checkEdits(const SemanticEdits& edits, const std::vector<std::string>& ids) {
  const auto table = attributeTableOf(edits);
  if (!table) {
    Diagnostic why = table.error();
    why.location = "/attributes";
    return why;
  }
  for (std::size_t i = 0; i < edits.places.size(); ++i) {
    const Outcome sound = checkAttributes(*table, AttributeOwner::Place, edits.places[i].attributes,
                                          "/places/" + std::to_string(i) + "/attributes");
    if (!sound) return sound;
  }
  const std::set<std::string> known(ids.begin(), ids.end());
  for (const auto& [id, attributes] : edits.bodies) {
    // A part "stand/bar" of a body has its own attributes.
    if (known.count(id) == 0 && known.count(firstStepOf(id)) == 0) {
      return Diagnostic{ErrorKind::MalformedInput, "", "/bodies/" + id, GLISSADE_TEXT("is not a body of this scenario"),
                        GLISSADE_TEXT("Correct the id.")};
    }
    const Outcome sound = checkAttributes(*table, AttributeOwner::Body, attributes, "/bodies/" + id + "/attributes");
    if (!sound) return sound;
  }
  return Done{};
}

}  // namespace glissade
