#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/describe.h"
#include "engine/base/limits.h"

namespace glissade {

// Formats for describe(): read(JsonCursor) returns the value or throws JsonError, write(value) returns JSON, and
// schema(definitions) returns the JSON schema of the value.

/// A value that a getter of JsonCursor reads. `text`: its schema.
template <class T>
struct GetterFormat {
  T (JsonCursor::*get)() const;
  const char* text;

  T read(const JsonCursor& at) const { return (at.*get)(); }
  JsonCursor::Json write(const T& value) const { return value; }
  JsonCursor::Json schema(SchemaDefinitions& /*definitions*/) const { return JsonCursor::Json::parse(text); }
};

inline constexpr GetterFormat<std::string> kText{&JsonCursor::text, R"({"type": "string"})"};
inline constexpr GetterFormat<std::string> kNonEmptyText{&JsonCursor::nonEmptyText,
                                                         R"({"type": "string", "minLength": 1})"};
/// The path of a file.
inline constexpr GetterFormat<std::string> kFilePath{&JsonCursor::exactText, R"({"type": "string", "minLength": 1})"};
inline constexpr GetterFormat<double> kNumber{&JsonCursor::number, R"({"type": "number"})"};
inline constexpr GetterFormat<double> kPositive{&JsonCursor::positiveNumber,
                                                R"({"type": "number", "exclusiveMinimum": 0})"};
inline constexpr GetterFormat<double> kCoordinate{&JsonCursor::coordinate, R"({"type": "number"})"};
inline constexpr GetterFormat<double> kLength{&JsonCursor::length, R"({"type": "number", "exclusiveMinimum": 0})"};
inline constexpr GetterFormat<std::uint64_t> kCount{&JsonCursor::wholeNumber, R"({"type": "integer", "minimum": 0})"};
inline constexpr GetterFormat<bool> kBoolean{&JsonCursor::boolean, R"({"type": "boolean"})"};

/// A value that functions read and write.
template <class Read, class Write>
struct FunctionFormat {
  Read reading;
  Write writing;
  const char* text;  ///< its schema

  auto read(const JsonCursor& at) const { return reading(at); }
  template <class T>
  JsonCursor::Json write(const T& value) const {
    return writing(value);
  }
  JsonCursor::Json schema(SchemaDefinitions& /*definitions*/) const { return JsonCursor::Json::parse(text); }
};
template <class Read, class Write>
FunctionFormat(Read, Write, const char*) -> FunctionFormat<Read, Write>;

/// Writes a value that has a JSON form.
inline constexpr auto kAsItIs = [](const auto& value) { return JsonCursor::Json(value); };

/// Metres, 0 or more.
inline constexpr FunctionFormat kLengthOrZero{[](const JsonCursor& at) {
                                                const double value = at.coordinate();
                                                if (value < 0.0)
                                                  at.fail(GLISSADE_TEXT("is below zero"),
                                                          GLISSADE_TEXT("Give metres, 0 or more."));
                                                return value;
                                              },
                                              kAsItIs, R"({"type": "number", "minimum": 0})"};

/// Pitch of a thread. Smaller pitches are not made; larger ones are straight motions.
inline constexpr FunctionFormat kPitch{
    [](const JsonCursor& at) {
      const double pitch = at.number();
      constexpr double kLeast = 1e-5;
      constexpr double kMost = 1.0;
      if (!(std::abs(pitch) >= kLeast && std::abs(pitch) <= kMost)) {
        at.fail(GLISSADE_TEXT("is not a pitch"), GLISSADE_TEXT("Give metres a turn, from 0.00001 to 1; below zero for "
                                                               "a left-handed thread."));
      }
      return pitch;
    },
    kAsItIs, R"({"type": "number"})"};

inline constexpr FunctionFormat kCountFrom1{[](const JsonCursor& at) {
                                              const std::uint64_t count = at.wholeNumber();
                                              if (count == 0) at.fail(GLISSADE_TEXT("is not 1 or more"));
                                              return count;
                                            },
                                            kAsItIs, R"({"type": "integer", "minimum": 1})"};

/// The value of an enumeration by its name.
template <class Enum, std::size_t count>
struct NamedFormat {
  EnumNames<Enum, count> names;

  Enum read(const JsonCursor& at) const { return at.named(names); }
  JsonCursor::Json write(Enum value) const { return names.of(value); }
  JsonCursor::Json schema(SchemaDefinitions& /*definitions*/) const { return {{"enum", names.names}}; }
};
template <class Enum, std::size_t count>
constexpr NamedFormat<Enum, count> named(const EnumNames<Enum, count>& names) {
  return {names};
}

/// A value of a described type. A header that does not show its description declares the format as an extern template.
template <class T>
struct ObjectFormat {
  T read(const JsonCursor& at) const;
  JsonCursor::Json write(const T& value) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};
template <class T>
T ObjectFormat<T>::read(const JsonCursor& at) const {
  return readDescribed<T>(at);
}
template <class T>
JsonCursor::Json ObjectFormat<T>::write(const T& value) const {
  return writeDescribed(value);
}
template <class T>
JsonCursor::Json ObjectFormat<T>::schema(SchemaDefinitions& definitions) const {
  return definitions.reference<T>();
}
template <class T>
inline constexpr ObjectFormat<T> kObject{};

/// A value that is described as a View, a type derived from its own, because files have several forms of it.
template <class Value, class View>
struct ViewFormat {
  Value read(const JsonCursor& at) const { return readDescribed<View>(at); }
  JsonCursor::Json write(const Value& value) const { return writeDescribed(View{value}); }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const { return definitions.reference<View>(); }
};

/// The most entries of a list that only the size of its file limits.
inline constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// A list of `least` to `most` values.
template <class Item>
struct ListFormat {
  Item item;
  std::size_t least = 0;
  std::size_t most = limits::kMostBodies;

  auto read(const JsonCursor& at) const {
    std::vector<decltype(item.read(at))> values;
    const std::size_t size = at.sizeUpTo(most);
    if (size == 0 && least > 0) at.fail(GLISSADE_TEXT("is empty"));
    if (size < least) at.fail({GLISSADE_TEXT("has fewer than %1 entries"), {least}});
    values.reserve(size);
    for (std::size_t i = 0; i < size; ++i) values.push_back(item.read(at.element(i)));
    return values;
  }
  template <class Values>
  JsonCursor::Json write(const Values& values) const {
    JsonCursor::Json list = JsonCursor::Json::array();
    for (const auto& value : values) list.push_back(item.write(value));
    return list;
  }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const {
    JsonCursor::Json list{{"type", "array"}, {"items", item.schema(definitions)}};
    if (least > 0) list["minItems"] = least;
    return list;
  }
};
template <class Item>
ListFormat(Item, std::size_t, std::size_t) -> ListFormat<Item>;
template <class Item>
constexpr ListFormat<Item> listOf(const Item& item, std::size_t least = 0, std::size_t most = limits::kMostBodies) {
  return {item, least, most};
}
template <class T>
inline constexpr ListFormat<ObjectFormat<T>> kObjects{};

/// A value, or null where there is none. Values are std::optional, or pointers where a member is written only.
template <class Item>
struct NullableFormat {
  static constexpr bool kTakesNothing = true;
  Item item;

  auto read(const JsonCursor& at) const {
    std::optional<decltype(item.read(at))> value;
    if (!at.json().is_null()) value = item.read(at);
    return value;
  }
  template <class Optional>
  JsonCursor::Json write(const Optional& value) const {
    return value ? item.write(*value) : JsonCursor::Json(nullptr);
  }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const {
    return {{"anyOf", {item.schema(definitions), {{"type", "null"}}}}};
  }
};
template <class Item>
constexpr NullableFormat<Item> orNull(const Item& item) {
  return {item};
}

/// An object whose keys are the keys of a map.
template <class Item>
struct MapFormat {
  Item item;

  auto read(const JsonCursor& at) const {
    at.expectObject();
    std::map<std::string, decltype(item.read(at))> values;
    for (const auto& entry : at.json().items()) values[entry.key()] = item.read(at.at(entry.key()));
    return values;
  }
  template <class Values>
  JsonCursor::Json write(const Values& values) const {
    JsonCursor::Json json = JsonCursor::Json::object();
    for (const auto& [key, value] : values) json[key] = item.write(value);
    return json;
  }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const {
    return {{"type", "object"}, {"additionalProperties", item.schema(definitions)}};
  }
};
template <class Item>
constexpr MapFormat<Item> mapOf(const Item& item) {
  return {item};
}

/// A pair as an object with two keys.
template <class Second>
struct PairFormat {
  const char* firstKey;
  const char* secondKey;
  Second second;

  std::pair<std::string, decltype(second.read(std::declval<const JsonCursor&>()))> read(const JsonCursor& at) const {
    at.allowOnly({firstKey, secondKey});
    return {at.at(firstKey).nonEmptyText(), second.read(at.at(secondKey))};
  }
  template <class Pair>
  JsonCursor::Json write(const Pair& pair) const {
    return {{firstKey, pair.first}, {secondKey, second.write(pair.second)}};
  }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const {
    return {{"type", "object"},
            {"additionalProperties", false},
            {"required", {firstKey, secondKey}},
            {"properties", {{firstKey, kNonEmptyText.schema(definitions)}, {secondKey, second.schema(definitions)}}}};
  }
};
template <class Second>
PairFormat(const char*, const char*, Second) -> PairFormat<Second>;

/// A message as its English text.
inline constexpr FunctionFormat kEnglish{[](const JsonCursor& at) { return Message(at.text()); },
                                         [](const Message& message) { return toString(message); },
                                         R"({"type": "string"})"};

/// Two texts in a list.
inline constexpr FunctionFormat kTextPair{
    [](const JsonCursor& at) {
      if (at.size() != 2) at.fail(GLISSADE_TEXT("is not two texts"));
      return std::pair(at.element(0).nonEmptyText(), at.element(1).nonEmptyText());
    },
    [](const auto& pair) {
      return JsonCursor::Json::array({pair.first, pair.second});
    },
    R"({"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "string", "minLength": 1}})"};

}  // namespace glissade
