#include "engine/places/attribute.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/number_text.h"
#include "engine/places/rigid_body.h"

namespace glissade {
namespace {

Diagnostic refusal(const Message& reason, const Message& advice) {
  return {ErrorKind::MalformedInput, "", "", reason, advice};
}

AttributeDefinition builtIn(const char* name, CatalogueText label, AttributeType type, AttributeOwner owner,
                            CatalogueText description) {
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
  const std::string& name = definition.name;
  switch (definition.type) {
    case AttributeType::Bool:
      if (!std::holds_alternative<bool>(value))
        return refusal({GLISSADE_TEXT("'%1' is neither true nor false"), {name}}, GLISSADE_TEXT("Give true or false."));
      break;
    case AttributeType::Integer:
    case AttributeType::Number: {
      const double* number = std::get_if<double>(&value);
      const bool whole = definition.type == AttributeType::Integer;
      const Message range{GLISSADE_TEXT("Give %1 from %2 to %3."),
                          {whole ? GLISSADE_TEXT("a whole number") : GLISSADE_TEXT("a number"), definition.minimum,
                           definition.maximum}};
      if (number == nullptr || !std::isfinite(*number)) {
        return refusal({GLISSADE_TEXT("'%1' is not a number"), {name}}, range);
      }
      if (whole && *number != std::floor(*number)) {
        return refusal({GLISSADE_TEXT("'%1' is not a whole number"), {name}}, range);
      }
      if (*number < definition.minimum || *number > definition.maximum) {
        return refusal({GLISSADE_TEXT("'%1' is %2, which is out of range"), {name, *number}}, range);
      }
      break;
    }
    case AttributeType::Text:
      if (!std::holds_alternative<std::string>(value)) {
        return refusal({GLISSADE_TEXT("'%1' is not a text"), {name}}, GLISSADE_TEXT("Give a text."));
      }
      break;
    case AttributeType::Choice: {
      const std::string* text = std::get_if<std::string>(&value);
      const auto& choices = definition.choices;
      if (text == nullptr || std::find(choices.begin(), choices.end(), *text) == choices.end()) {
        return refusal({GLISSADE_TEXT("'%1' is not one of its choices"), {name}},
                       {GLISSADE_TEXT("Give one of %1."), {joined(choices)}});
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
  AttributeDefinition mobility = builtIn("mobility", GLISSADE_TEXT("Mobility"), Type::Choice, kBody,
                                         GLISSADE_TEXT("Static bodies shape the places; mobile ones clutter them."));
  mobility.choices.assign(kMobilityNames.names.begin(), kMobilityNames.names.end());
  mobility.initial = std::string(kMobilityNames.of(Mobility::Static));
  AttributeDefinition tool = builtIn("needs_tool", GLISSADE_TEXT("Needs tool"), Type::Choice, kBody,
                                     GLISSADE_TEXT("Which tool turns the body: by_shape, none, or one of the tools."));
  tool.choices = {"by_shape", "none", "hex_key", "socket", "screwdriver", "open_wrench", "circlip_pliers"};
  tool.initial = std::string("by_shape");
  definitions_ = {
      bounded(builtIn("complexity", GLISSADE_TEXT("Complexity"), Type::Integer, kPlace,
                      GLISSADE_TEXT(
                          "How hard the place is to cross: 1 for the widest, one more each time the width halves.")),
              1, 99, 1, ""),
      builtIn("cluttered", GLISSADE_TEXT("Cluttered"), Type::Bool, kPlace,
              GLISSADE_TEXT("Mobile bodies are in the place.")),
      bounded(builtIn("narrowness", GLISSADE_TEXT("Narrowness"), Type::Number, kPlace,
                      GLISSADE_TEXT("Diameter of the largest ball that fits at the widest spot.")),
              0, 1e6, 0, "m"),
      builtIn("shape", GLISSADE_TEXT("Shape"), Type::Text, kPlace,
              GLISSADE_TEXT("Shape of the place's section, as the objects' shapes are called.")),
      bounded(
          builtIn("compatibility", GLISSADE_TEXT("Compatibility"), Type::Number, kPlace,
                  GLISSADE_TEXT("Whether the object goes through: 0 not at all, from 0.5 on it fits, 1 with ease.")),
          0, 1, 1, ""),
      builtIn("forbidden", GLISSADE_TEXT("Forbidden"), Type::Bool, kPlace,
              GLISSADE_TEXT("No path may lead through the place.")),
      bounded(builtIn("preference", GLISSADE_TEXT("Preference"), Type::Number, kPlace,
                      GLISSADE_TEXT("Paths through the place count this many times shorter.")),
              0.01, 100, 1, ""),
      mobility,
      builtIn("shape", GLISSADE_TEXT("Shape"), Type::Text, kBody, GLISSADE_TEXT("What the body is shaped like.")),
      builtIn("class", GLISSADE_TEXT("Class"), Type::Text, kBody,
              GLISSADE_TEXT("Class of the body, whose attributes it has: screw, seal, base_part.")),
      bounded(builtIn("mass", GLISSADE_TEXT("Mass"), Type::Number, kBody,
                      GLISSADE_TEXT("Mass of the body. 0: by its volume and density.")),
              0, 1e6, 0, "kg"),
      builtIn("fragile", GLISSADE_TEXT("Fragile"), Type::Bool, kBody,
              GLISSADE_TEXT("The body is removed as early as possible, and is assembled as late as possible.")),
      builtIn("base", GLISSADE_TEXT("Base part"), Type::Bool, kBody,
              GLISSADE_TEXT("The assembly begins with the body: it is not removed.")),
      builtIn("stays", GLISSADE_TEXT("Fixed as base"), Type::Bool, kBody, GLISSADE_TEXT("The body is not removed.")),
      builtIn("goes_with", GLISSADE_TEXT("Removed with"), Type::Text, kBody,
              GLISSADE_TEXT("Bodies that are removed together with this one, with commas.")),
      builtIn("goes_before", GLISSADE_TEXT("Removed before"), Type::Text, kBody,
              GLISSADE_TEXT("Bodies that are removed after this one, with commas.")),
      tool,
  };
}

Outcome AttributeTable::add(AttributeDefinition definition) {
  if (!isWord(definition.name)) {
    return refusal({GLISSADE_TEXT("the attribute name '%1' is not a word"), {definition.name}},
                   GLISSADE_TEXT("Use lower-case letters, digits and '_', a letter first."));
  }
  const AttributeDefinition* known = find(definition.owner, definition.name);
  if (known != nullptr && !isKnowledge(*known)) {
    return refusal({GLISSADE_TEXT("there is an attribute '%1' already"), {definition.name}},
                   GLISSADE_TEXT("Choose another name."));
  }
  if (definition.type == AttributeType::Choice && definition.choices.empty()) {
    return refusal({GLISSADE_TEXT("the attribute '%1' has no choices"), {definition.name}},
                   GLISSADE_TEXT("Give at least one."));
  }
  for (auto choice = definition.choices.begin(); choice != definition.choices.end(); ++choice) {
    if (choice->empty()) {
      return refusal({GLISSADE_TEXT("the attribute '%1' has a choice without a name"), {definition.name}},
                     GLISSADE_TEXT("Remove it."));
    }
    if (std::find(definition.choices.begin(), choice, *choice) != choice) {
      return refusal({GLISSADE_TEXT("the attribute '%1' has the choice '%2' twice"), {definition.name, *choice}},
                     GLISSADE_TEXT("Remove one."));
    }
  }
  if (definition.minimum > definition.maximum) {
    return refusal({GLISSADE_TEXT("the attribute '%1' has a minimum above its maximum"), {definition.name}},
                   GLISSADE_TEXT("Swap them."));
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
