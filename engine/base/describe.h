#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/json_reader.h"

namespace glissade {

// A type of a file is described once, by a function template that visits its members, as Serialize() of Drake:
//
//   template <class Archive>
//   void describe(Archive& hole, Type<Hole>) {
//     hole.type("hole", "A cylinder that is cut out.");
//     hole.required("radius", &Hole::radius, kLength, "Metres.");
//     hole.optional("name", &Hole::name, kText);
//   }
//
// readDescribed(), writeDescribed() and describedSchema() follow from it. A format reads, writes and describes the
// value of a member. A member is a pointer to a member or an Accessor. Archives:
//
//   type(name, about)                            name of the type among the definitions of the schema
//   required(key, member, format, about)         the reader demands it
//   optional(key, member, format, about, when)   absent: the member keeps its initial value. It is written where it
//                                                differs from that value, or as `when` states
//   embed(member)                                the keys of the member's type stand beside those of this type
//   constant(key, value)                         the reader refuses every other value
//   computed(key, function, format, about)       it is written and not read
//   ignored(key, format, about)                  a remark in the file: it is neither kept nor written
//   check(function)                              called by the reader with the value and its JsonCursor

/// Selects an overload of describe().
template <class T>
struct Type {};

/// States that an optional member is always written.
struct Always {
  bool operator()(const auto& /*value*/) const { return true; }
};

/// A member that is read and written by functions: get(object) and set(object, value).
template <class Get, class Set>
struct Accessor {
  Get get;
  Set set;
};
template <class Get, class Set>
Accessor(Get, Set) -> Accessor<Get, Set>;

namespace describing {

using Json = JsonCursor::Json;

template <class T>
constexpr bool kIsOptional = false;
template <class T>
constexpr bool kIsOptional<std::optional<T>> = true;

template <class T, class Base, class Value>
const Value& valueOf(const T& object, Value Base::*member) {
  return object.*member;
}
template <class T, class Get, class Set>
auto valueOf(const T& object, const Accessor<Get, Set>& accessor) {
  return accessor.get(object);
}
template <class T, class Base, class Value, class Read>
void assign(T& object, Value Base::*member, Read&& read) {
  object.*member = std::forward<Read>(read);
}
template <class T, class Get, class Set, class Read>
void assign(T& object, const Accessor<Get, Set>& accessor, Read&& read) {
  accessor.set(object, std::forward<Read>(read));
}

template <class Value, class Format>
Json written(const Value& value, const Format& format) {
  if constexpr (kIsOptional<Value> && !requires { Format::kTakesNothing; }) {
    return format.write(*value);
  } else {
    return format.write(value);
  }
}

/// True if an optional value would be missed in a file.
template <class Value>
bool differs(const Value& value, const Value& initial) {
  if constexpr (kIsOptional<Value>) {
    return value.has_value();
  } else if constexpr (requires { value.empty(); }) {
    return !value.empty();
  } else {
    return !(value == initial);
  }
}

/// The keys of a type, in their order, and its name.
template <class T>
class KeyArchive {
 public:
  explicit KeyArchive(std::vector<std::string>& keys, std::string* name = nullptr) : keys_(keys), name_(name) {}

  void type(const char* name, const char* /*about*/ = "") {
    if (name_ != nullptr) *name_ = name;
  }
  template <class Member, class Format>
  void required(const char* key, Member /*member*/, const Format& /*format*/, const char* /*about*/ = "") {
    keys_.emplace_back(key);
  }
  template <class Member, class Format, class When = void*>
  void optional(const char* key, Member /*member*/, const Format& /*format*/, const char* /*about*/ = "",
                When /*when*/ = {}) {
    keys_.emplace_back(key);
  }
  template <class Base, class Value>
  void embed(Value Base::* /*member*/) {
    KeyArchive<Value> inner(keys_);
    describe(inner, Type<Value>());
  }
  template <class Value>
  void constant(const char* key, const Value& /*value*/) {
    keys_.emplace_back(key);
  }
  template <class Compute, class Format>
  void computed(const char* key, const Compute& /*compute*/, const Format& /*format*/, const char* /*about*/ = "") {
    keys_.emplace_back(key);
  }
  template <class Format>
  void ignored(const char* key, const Format& /*format*/, const char* /*about*/ = "") {
    keys_.emplace_back(key);
  }
  template <class Check>
  void check(const Check& /*check*/) {}

 private:
  std::vector<std::string>& keys_;
  std::string* name_;
};

template <class T>
class ReadArchive {
 public:
  ReadArchive(const JsonCursor& at, T& object) : at_(at), object_(object) {}

  void type(const char* /*name*/, const char* /*about*/ = "") {}
  template <class Member, class Format>
  void required(const char* key, Member member, const Format& format, const char* /*about*/ = "") {
    assign(object_, member, format.read(at_.at(key)));
  }
  template <class Member, class Format, class When = void*>
  void optional(const char* key, Member member, const Format& format, const char* /*about*/ = "", When /*when*/ = {}) {
    if (const auto found = at_.find(key)) assign(object_, member, format.read(*found));
  }
  template <class Base, class Value>
  void embed(Value Base::*member) {
    ReadArchive<Value> inner(at_, object_.*member);
    describe(inner, Type<Value>());
  }
  template <class Value>
  void constant(const char* key, const Value& value) {
    const JsonCursor found = at_.at(key);
    if (found.json() == Json(value)) return;
    if constexpr (std::is_integral_v<Value>) {
      found.fail({GLISSADE_TEXT("is not %1"), {value}}, GLISSADE_TEXT("Use a newer Glissade."));
    } else {
      found.fail({GLISSADE_TEXT("is not \"%1\""), {value}});
    }
  }
  template <class Compute, class Format>
  void computed(const char* /*key*/, const Compute& /*compute*/, const Format& /*format*/, const char* /*about*/ = "") {
  }
  template <class Format>
  void ignored(const char* key, const Format& format, const char* /*about*/ = "") {
    if (const auto found = at_.find(key)) (void)format.read(*found);
  }
  template <class Check>
  void check(const Check& check) {
    check(object_, at_);
  }

 private:
  const JsonCursor& at_;
  T& object_;
};

template <class T>
class WriteArchive {
 public:
  WriteArchive(const T& object, const T& initial, Json& json) : object_(object), initial_(initial), json_(json) {}

  void type(const char* /*name*/, const char* /*about*/ = "") {}
  template <class Member, class Format>
  void required(const char* key, Member member, const Format& format, const char* /*about*/ = "") {
    json_[key] = written(valueOf(object_, member), format);
  }
  template <class Member, class Format>
  void optional(const char* key, Member member, const Format& format, const char* about = "") {
    if (differs(valueOf(object_, member), valueOf(initial_, member))) required(key, member, format, about);
  }
  template <class Member, class Format, class When>
  void optional(const char* key, Member member, const Format& format, const char* about, const When& when) {
    if (when(object_)) required(key, member, format, about);
  }
  template <class Base, class Value>
  void embed(Value Base::*member) {
    WriteArchive<Value> inner(object_.*member, initial_.*member, json_);
    describe(inner, Type<Value>());
  }
  template <class Value>
  void constant(const char* key, const Value& value) {
    json_[key] = value;
  }
  template <class Compute, class Format>
  void computed(const char* key, const Compute& compute, const Format& format, const char* /*about*/ = "") {
    json_[key] = format.write(compute(object_));
  }
  template <class Format>
  void ignored(const char* /*key*/, const Format& /*format*/, const char* /*about*/ = "") {}
  template <class Check>
  void check(const Check& /*check*/) {}

 private:
  const T& object_;
  const T& initial_;
  Json& json_;
};

template <class T>
struct Shape {
  std::string name;
  std::vector<std::string> keys;
};

template <class T>
const Shape<T>& shapeOf() {
  static const Shape<T> shape = [] {
    Shape<T> made;
    KeyArchive<T> archive(made.keys, &made.name);
    describe(archive, Type<T>());
    return made;
  }();
  return shape;
}

}  // namespace describing

/// Reads an object with exactly the described keys. Throws JsonError.
template <class T>
T readDescribed(const JsonCursor& at) {
  at.allowOnly(describing::shapeOf<T>().keys);
  T value{};
  describing::ReadArchive<T> archive(at, value);
  describe(archive, Type<T>());
  return value;
}

template <class T>
JsonCursor::Json writeDescribed(const T& value) {
  static const T kInitial{};
  JsonCursor::Json json = JsonCursor::Json::object();
  describing::WriteArchive<T> archive(value, kInitial, json);
  describe(archive, Type<T>());
  return json;
}

/// Definitions that the schema of one document refers to.
class SchemaDefinitions {
 public:
  using Json = JsonCursor::Json;

  /// A reference to the schema of the type, which is made at the first call. Throws std::logic_error where another type
  /// has its name.
  template <class T>
  Json reference();
  /// A reference to a schema that is not described by a type.
  Json reference(const std::string& name, const Json& schema);

  /// The schema of a type without definitions.
  template <class T>
  Json schemaOf();

  const Json& all() const { return all_; }

 private:
  Json all_ = Json::object();
  std::map<std::string, const void*> owners_{};  ///< a type for each of its names, by the address of its shape
};

/// The JSON schema (draft 7) of a document whose root is of the type.
template <class T>
JsonCursor::Json describedSchema(const char* title) {
  SchemaDefinitions definitions;
  JsonCursor::Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  schema.update(definitions.schemaOf<T>());
  if (!definitions.all().empty()) schema["definitions"] = definitions.all();
  return schema;
}

namespace describing {

template <class T>
class SchemaArchive {
 public:
  SchemaArchive(SchemaDefinitions& definitions, Json& schema) : definitions_(definitions), schema_(schema) {}

  void type(const char* /*name*/, const char* about = "") {
    if (*about != '\0') schema_["description"] = about;
    schema_["type"] = "object";
    schema_["additionalProperties"] = false;
    schema_["required"] = Json::array();
    schema_["properties"] = Json::object();
  }
  template <class Member, class Format>
  void required(const char* key, Member member, const Format& format, const char* about = "") {
    optional(key, member, format, about);
    schema_["required"].push_back(key);
  }
  template <class Member, class Format, class When = void*>
  void optional(const char* key, Member /*member*/, const Format& format, const char* about = "", When /*when*/ = {}) {
    Json property = Json::object();
    if (*about != '\0') property["description"] = about;
    property.update(format.schema(definitions_));
    if (*about != '\0') property["description"] = about;
    schema_["properties"][key] = std::move(property);
  }
  template <class Base, class Value>
  void embed(Value Base::* /*member*/) {
    const Json inner = definitions_.schemaOf<Value>();
    schema_["properties"].update(inner["properties"]);
    for (const Json& key : inner["required"]) schema_["required"].push_back(key);
  }
  template <class Value>
  void constant(const char* key, const Value& value) {
    schema_["properties"][key] = {{"const", value}};
    schema_["required"].push_back(key);
  }
  template <class Compute, class Format>
  void computed(const char* key, const Compute& compute, const Format& format, const char* about = "") {
    optional(key, compute, format, about);
  }
  template <class Format>
  void ignored(const char* key, const Format& format, const char* about = "") {
    optional(key, nullptr, format, about);
  }
  template <class Check>
  void check(const Check& /*check*/) {}

 private:
  SchemaDefinitions& definitions_;
  Json& schema_;
};

}  // namespace describing

template <class T>
JsonCursor::Json SchemaDefinitions::schemaOf() {
  Json schema = Json::object();
  describing::SchemaArchive<T> archive(*this, schema);
  describe(archive, Type<T>());
  if (schema["required"].empty()) schema.erase("required");
  return schema;
}

inline JsonCursor::Json SchemaDefinitions::reference(const std::string& name, const Json& schema) {
  all_[name] = schema;
  return {{"$ref", "#/definitions/" + name}};
}

template <class T>
JsonCursor::Json SchemaDefinitions::reference() {
  const auto& shape = describing::shapeOf<T>();
  const std::string& name = shape.name;
  const auto [owner, isNew] = owners_.emplace(name, &shape);
  if (owner->second != &shape) throw std::logic_error("two types have the name " + name);
  if (isNew) {
    all_[name] = nullptr;  // the type may contain itself
    Json schema = schemaOf<T>();
    all_[name] = std::move(schema);
  }
  return {{"$ref", "#/definitions/" + name}};
}

}  // namespace glissade
