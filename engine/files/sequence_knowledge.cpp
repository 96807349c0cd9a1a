#include "engine/files/sequence_knowledge.h"

#include <algorithm>
#include <sstream>

#include "engine/files/body_classes_json.h"
#include "engine/places/held_edits.h"

namespace glissade {
namespace {

/// The value of an attribute with this type. Nothing where there is none, or where a user's attribute of the same name
/// has another type.
template <class Value>
std::optional<Value> valueIn(const Attributes& attributes, const std::string& name) {
  const auto known = attributes.find(name);
  if (known == attributes.end()) return std::nullopt;
  const auto* value = std::get_if<Value>(&known->second);
  return value == nullptr ? std::nullopt : std::optional<Value>(*value);
}

/// The names in an attribute, separated by commas.
std::vector<std::string> namesIn(const Attributes& attributes, const std::string& attribute) {
  std::vector<std::string> names;
  std::istringstream in(valueIn<std::string>(attributes, attribute).value_or(""));
  for (std::string name; std::getline(in, name, ',');) {
    const std::size_t first = name.find_first_not_of(' ');
    if (first != std::string::npos) names.push_back(name.substr(first, name.find_last_not_of(' ') + 1 - first));
  }
  return names;
}

/// Adds a group and merges groups that have a name in common.
void addTogether(std::vector<std::string> names, std::vector<std::vector<std::string>>& groups) {
  for (auto group = groups.begin(); group != groups.end();) {
    const bool common = std::any_of(group->begin(), group->end(), [&](const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
    if (!common) {
      ++group;
      continue;
    }
    for (const std::string& name : *group) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    group = groups.erase(group);
  }
  groups.push_back(std::move(names));
}

void addBody(const BodyId& body, const Attributes& attributes, SequenceDemands& demands) {
  const std::string& id = body.text();
  const auto isTrue = [&](const char* name) { return valueIn<bool>(attributes, name).value_or(false); };
  if (isTrue("base") || isTrue("stays")) demands.stay.push_back(id);
  if (isTrue("fragile")) demands.fragile.push_back(id);
  if (const double mass = valueIn<double>(attributes, "mass").value_or(0.0); mass > 0.0) {
    demands.masses.emplace_back(id, mass);
  }
  const std::string tool = valueIn<std::string>(attributes, "needs_tool").value_or("by_shape");
  if (tool != "by_shape") demands.tools.emplace_back(id, tool);
  for (const std::string& then : namesIn(attributes, "goes_before")) demands.before.emplace_back(id, then);
  std::vector<std::string> together = namesIn(attributes, "goes_with");
  if (together.empty()) return;
  together.insert(together.begin(), id);
  addTogether(std::move(together), demands.together);
}

/// Attributes of a body, which override those of the scenario's body that contains it.
Attributes attributesOf(const BodyId& id, const SemanticEdits& edits) {
  Attributes attributes;
  for (const BodyId& each : {id, bodyIdOf(id)}) {
    const auto known = edits.bodies.find(each.text());
    if (known != edits.bodies.end()) attributes.insert(known->second.begin(), known->second.end());
  }
  return attributes;
}

/// The user's own attributes, with their defaults where they are not set.
Attributes forCosts(const Attributes& attributes, const SemanticEdits& edits) {
  Attributes own;
  for (const AttributeDefinition& definition : edits.definitions) {
    if (definition.owner != AttributeOwner::Body) continue;
    const auto known = attributes.find(definition.name);
    own[definition.name] = known == attributes.end() ? definition.initial : known->second;
  }
  return own;
}

Diagnostic unknownClass(const BodyId& id, const std::string& name, const BodyClasses& classes) {
  std::string known;
  for (const BodyClass& each : classes.all()) known += (known.empty() ? "" : ", ") + each.name;
  return {ErrorKind::MalformedInput,
          "",
          "/bodies",
          {GLISSADE_TEXT("the class of '%1' is '%2', which is not a class of bodies"), {id.text(), name}},
          {GLISSADE_TEXT("Choose one of %1, or add it under /sequence/classes."), {known}}};
}

}  // namespace

Result<SequenceDemands> knownDemands(const Scenario& scenario, const AssembledProduct& product) {
  std::vector<BodyClass> all = usualBodyClasses();
  all.insert(all.end(), scenario.sequence.classes.begin(), scenario.sequence.classes.end());
  const auto classes = BodyClasses::of(all);
  if (!classes) {
    Diagnostic why = classes.error();
    why.location = "/sequence/classes";
    return why;
  }
  SequenceDemands demands = scenario.sequence;
  demands.joints = scenario.joints;
  const SemanticEdits edits = heldEdits(semanticEditsOf(scenario), product.tree);
  for (const RigidBody& body : product.bodies) {
    Attributes attributes = attributesOf(body.id, edits);
    const std::string name = valueIn<std::string>(attributes, "class").value_or("");
    if (!name.empty()) {
      if (classes->find(name) == nullptr) return unknownClass(body.id, name, *classes);
      const Attributes inherited = classes->attributesOf(name);
      attributes.insert(inherited.begin(), inherited.end());
      const std::string fastener = classes->fastenerOf(name);
      if (!fastener.empty()) demands.fasteners.emplace_back(body.id.text(), fastener);
    }
    addBody(body.id, attributes, demands);
    Attributes own = forCosts(attributes, edits);
    if (!own.empty()) demands.attributes[body.id.text()] = std::move(own);
  }
  return demands;
}

std::vector<std::string> classesOf(const SemanticEdits& edits, const std::vector<RigidBody>& bodies) {
  std::vector<std::string> classes;
  for (const RigidBody& body : bodies) {
    classes.push_back(valueIn<std::string>(attributesOf(body.id, edits), "class").value_or(""));
  }
  return classes;
}

}  // namespace glissade
