#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/base/result.h"
#include "engine/geometry/pose.h"
#include "engine/model/attributes.h"

namespace glissade {

enum class AttributeType { Bool, Integer, Number, Text, Choice };
/// Kind of thing that an attribute describes.
enum class AttributeOwner { Place, Body };

inline constexpr EnumNames<AttributeType, 5> kAttributeTypeNames{{"bool", "integer", "number", "text", "choice"}};
inline constexpr EnumNames<AttributeOwner, 2> kAttributeOwnerNames{{"place", "body"}};

/// Definition of an attribute. Its type decides how it is edited, checked and used in rules (paper 2, section 5.1.1:
/// actual attributes are derived from a generic one).
struct AttributeDefinition {
  std::string name;  ///< name in files and rules: lower case, digits, '_'
  Message label;
  AttributeType type = AttributeType::Text;
  AttributeOwner owner = AttributeOwner::Place;
  std::string unit;  ///< unit for people, for example "m"
  double minimum = -1e9;
  double maximum = 1e9;
  std::vector<std::string> choices;
  Message description;
  AttributeValue initial = std::string();  ///< value where nothing was computed or edited
  bool builtIn = false;                    ///< cannot be renamed or removed

  friend bool operator==(const AttributeDefinition&, const AttributeDefinition&) = default;
};

/// The value as a person writes it, for example yes, 3, 0.25, circle.
std::string toText(const AttributeValue& value);
/// An initial value of the right type.
AttributeValue initialValue(const AttributeDefinition& definition);

/// Refuses (ErrorKind::MalformedInput, place empty) a value of the wrong type or out of range.
Outcome checkValue(const AttributeDefinition& definition, const AttributeValue& value);

/// All attributes: the built-in ones, then the user's.
class AttributeTable {
 public:
  /// Built-in attributes of places: complexity, cluttered, narrowness, shape, compatibility, forbidden, preference.
  /// Built-in attributes of bodies: mobility and shape, and those for assembly plans: class, mass, fragile, base,
  /// stays, goes_with, goes_before, needs_tool.
  AttributeTable();

  /// Adds a definition. It replaces an attribute for assembly plans of the same name. Refuses a name that another
  /// attribute of the same owner has, or that is not a word of lower-case letters, digits and '_', and choices without
  /// any choice.
  Outcome add(AttributeDefinition definition);
  /// The definition of a name; null where there is none.
  const AttributeDefinition* find(AttributeOwner owner, std::string_view name) const;
  const std::vector<AttributeDefinition>& definitions() const { return definitions_; }

 private:
  std::vector<AttributeDefinition> definitions_;
};

/// A user's edit of one place. It is bound to a point, because identification may renumber places.
struct PlaceEdit {
  Vector3 at = Vector3::Zero();  ///< a point inside the place, world
  std::string name;              ///< name by the user; empty: the computed one
  Attributes attributes;

  friend bool operator==(const PlaceEdit&, const PlaceEdit&) = default;
};

/// A milestone that a user has put into a border (paper 2, section 4.1), instead of a random one.
struct MilestoneEdit {
  Vector3 at = Vector3::Zero();  ///< a point inside the border's overlap, world
  Pose q;                        ///< the configuration to pass through

  friend bool operator==(const MilestoneEdit&, const MilestoneEdit&) = default;
};

/// All edits of the scene by a user, which override computed values.
struct SemanticEdits {
  std::vector<AttributeDefinition> definitions;  ///< the user's own attributes
  std::vector<PlaceEdit> places;
  std::map<std::string, Attributes> bodies;  ///< attributes by id of a body, including the object's, or of an assembly
  std::vector<MilestoneEdit> milestones;

  friend bool operator==(const SemanticEdits&, const SemanticEdits&) = default;
};

/// The built-in attributes with the user's. Definitions that clash are an error naming the attribute.
Result<AttributeTable> attributeTableOf(const SemanticEdits& edits);

}  // namespace glissade
