#include "engine/environment/attribute.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/number_text.h"
#include "engine/environment/rigid_body.h"

namespace glissade {
namespace {

Diagnostic refusal(const Message& reason, const Message& advice) {
  return {ErrorKind::MalformedInput, "", "", reason, advice};
}

AttributeDefinition builtIn(const char* name, const char* label, AttributeType type, AttributeOwner owner,
                            const char* description) {
  AttributeDefinition definition;
  definition.name = name;
  definition.label = label;
  definition.type = type;
  definition.owner = owner;
  definition.description = description;
  definition.builtIn = true;
  definition.initial = initialValue(definition);
  return definition;
}

/// True for attributes of bodies that assembly plans use. A user's attribute of the same name replaces it.
bool isKnowledge(const AttributeDefinition& definition) {
  constexpr std::array<std::string_view, 8> kKnowledge{"class", "mass",      "fragile",     "base",
                                                       "stays", "goes_with", "goes_before", "needs_tool"};
  return definition.builtIn && definition.owner == AttributeOwner::Body &&
         std::find(kKnowledge.begin(), kKnowledge.end(), definition.name) != kKnowledge.end();
}

bool isWord(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  if (name.empty() || !letter(name.front())) return false;
  return std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

}  // namespace

std::string toText(const AttributeValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
  if (const double* number = std::get_if<double>(&value)) return toText(*number);
  return std::get<std::string>(value);
}

AttributeValue initialValue(const AttributeDefinition& definition) {
  switch (definition.type) {
    case AttributeType::Bool: return false;
    case AttributeType::Integer:
    case AttributeType::Number: return std::clamp(0.0, definition.minimum, definition.maximum);
    case AttributeType::Choice: return definition.choices.empty() ? std::string() : definition.choices.front();
    case AttributeType::Text: break;
  }
  return std::string();
}

Outcome checkValue(const AttributeDefinition& definition, const AttributeValue& value) {
  const std::string what = "'" + definition.name + "'";
  switch (definition.type) {
    case AttributeType::Bool:
      if (!std::holds_alternative<bool>(value))
        return refusal(what + " is neither true nor false", "Give true or false.");
      break;
    case AttributeType::Integer:
    case AttributeType::Number: {
      const double* number = std::get_if<double>(&value);
      const bool whole = definition.type == AttributeType::Integer;
      const std::string kind = whole ? "a whole number" : "a number";
      const std::string range =
          "Give " + kind + " from " + toText(definition.minimum) + " to " + toText(definition.maximum) + ".";
      if (number == nullptr || !std::isfinite(*number)) return refusal(what + " is not a number", range);
      if (whole && *number != std::floor(*number)) return refusal(what + " is not a whole number", range);
      if (*number < definition.minimum || *number > definition.maximum) {
        return refusal(what + " is " + toText(*number) + ", which is out of range", range);
      }
      break;
    }
    case AttributeType::Text:
      if (!std::holds_alternative<std::string>(value)) return refusal(what + " is not a text", "Give a text.");
      break;
    case AttributeType::Choice: {
      const std::string* text = std::get_if<std::string>(&value);
      const auto& choices = definition.choices;
      if (text == nullptr || std::find(choices.begin(), choices.end(), *text) == choices.end()) {
        return refusal(what + " is not one of its choices", "Give one of " + joined(choices) + ".");
      }
      break;
    }
  }
  return Done{};
}

AttributeTable::AttributeTable() {
  using Type = AttributeType;
  constexpr auto kPlace = AttributeOwner::Place;
  constexpr auto kBody = AttributeOwner::Body;
  const auto bounded = [](AttributeDefinition definition, double minimum, double maximum, double initial,
                          const char* unit) {
    definition.minimum = minimum;
    definition.maximum = maximum;
    definition.initial = initial;
    definition.unit = unit;
    return definition;
  };
  AttributeDefinition mobility =
      builtIn("mobility", "Mobility", Type::Choice, kBody, "Static bodies shape the places; mobile ones clutter them.");
  mobility.choices.assign(kMobilityNames.names.begin(), kMobilityNames.names.end());
  mobility.initial = std::string(kMobilityNames.of(Mobility::Static));
  AttributeDefinition tool = builtIn("needs_tool", "Needs tool", Type::Choice, kBody,
                                     "Which tool turns the body: by_shape, none, or one of the tools.");
  tool.choices = {"by_shape", "none", "hex_key", "socket", "screwdriver", "open_wrench"};
  tool.initial = std::string("by_shape");
  definitions_ = {
      bounded(builtIn("complexity", "Complexity", Type::Integer, kPlace,
                      "How hard the place is to cross: 1 for the widest, one more each time the width halves."),
              1, 99, 1, ""),
      builtIn("cluttered", "Cluttered", Type::Bool, kPlace, "Mobile bodies are in the place."),
      bounded(builtIn("narrowness", "Narrowness", Type::Number, kPlace,
                      "Diameter of the largest ball that fits at the widest spot."),
              0, 1e6, 0, "m"),
      builtIn("shape", "Shape", Type::Text, kPlace, "Shape of the place's section, as the objects' shapes are called."),
      bounded(builtIn("compatibility", "Compatibility", Type::Number, kPlace,
                      "Whether the object goes through: 0 not at all, from 0.5 on it fits, 1 with ease."),
              0, 1, 1, ""),
      builtIn("forbidden", "Forbidden", Type::Bool, kPlace, "No path may lead through the place."),
      bounded(builtIn("preference", "Preference", Type::Number, kPlace,
                      "Ways through the place count this many times shorter."),
              0.01, 100, 1, ""),
      mobility,
      builtIn("shape", "Shape", Type::Text, kBody, "What the body is shaped like."),
      builtIn("class", "Class", Type::Text, kBody,
              "Class of the body, whose attributes it has: screw, seal, base_part."),
      bounded(builtIn("mass", "Mass", Type::Number, kBody, "Mass of the body. 0: by its volume and density."), 0, 1e6,
              0, "kg"),
      builtIn("fragile", "Fragile", Type::Bool, kBody,
              "The body leaves as early as it can, and is put in as late as it can."),
      builtIn("base", "Base", Type::Bool, kBody, "The assembly begins with the body: it does not leave."),
      builtIn("stays", "Stays", Type::Bool, kBody, "The body does not leave."),
      builtIn("goes_with", "Goes with", Type::Text, kBody, "Bodies that leave together with this one, with commas."),
      builtIn("goes_before", "Goes before", Type::Text, kBody, "Bodies that leave after this one, with commas."),
      tool,
  };
}

Outcome AttributeTable::add(AttributeDefinition definition) {
  if (!isWord(definition.name)) {
    return refusal("the attribute name '" + definition.name + "' is not a word",
                   "Use lower-case letters, digits and '_', a letter first.");
  }
  const AttributeDefinition* known = find(definition.owner, definition.name);
  if (known != nullptr && !isKnowledge(*known)) {
    return refusal("there is an attribute '" + definition.name + "' already", "Choose another name.");
  }
  if (definition.type == AttributeType::Choice && definition.choices.empty()) {
    return refusal("the attribute '" + definition.name + "' has no choices", "Give at least one.");
  }
  for (auto choice = definition.choices.begin(); choice != definition.choices.end(); ++choice) {
    if (choice->empty()) {
      return refusal("the attribute '" + definition.name + "' has a choice without a name", "Remove it.");
    }
    if (std::find(definition.choices.begin(), choice, *choice) != choice) {
      return refusal("the attribute '" + definition.name + "' has the choice '" + *choice + "' twice", "Remove one.");
    }
  }
  if (definition.minimum > definition.maximum) {
    return refusal("the attribute '" + definition.name + "' has a minimum above its maximum", "Swap them.");
  }
  const Outcome initial = checkValue(definition, definition.initial);
  if (!initial) return initial;
  std::erase_if(definitions_, [&](const AttributeDefinition& other) {
    return isKnowledge(other) && other.owner == definition.owner && other.name == definition.name;
  });
  definitions_.push_back(std::move(definition));
  return Done{};
}

const AttributeDefinition* AttributeTable::find(AttributeOwner owner, std::string_view name) const {
  const auto found = std::find_if(definitions_.begin(), definitions_.end(), [&](const auto& definition) {
    return definition.owner == owner && definition.name == name;
  });
  return found == definitions_.end() ? nullptr : &*found;
}

Result<AttributeTable> attributeTableOf(const SemanticEdits& edits) {
  AttributeTable table;
  for (const AttributeDefinition& definition : edits.definitions) {
    const Outcome added = table.add(definition);
    if (!added) return added.error();
  }
  return table;
}

}  // namespace glissade
