#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/json_text.h"

namespace glissade {

/// Thrown by JsonCursor, caught where a file's reader begins; never leaves this room. The
/// diagnostic's file is empty.
struct JsonFailure {
  Diagnostic diagnostic;
};

/// A value inside a document together with its JSON pointer. Every reading function either gives a
/// sound value or throws JsonFailure naming the pointer.
class JsonCursor {
 public:
  explicit JsonCursor(const Json& document) : value_(&document) {}

  const std::string& pointer() const { return pointer_; }
  const Json& json() const { return *value_; }
  [[noreturn]] void fail(const std::string& reason, const std::string& advice = "Mend the file there.") const;

  /// The value is an object with no other keys than these.
  void allowOnly(std::initializer_list<std::string_view> keys) const;
  JsonCursor at(std::string_view key) const;
  std::optional<JsonCursor> find(std::string_view key) const;
  /// The members of an object with their keys.
  std::vector<std::pair<std::string, JsonCursor>> members() const;
  std::vector<JsonCursor> elements() const;
  /// The elements of an array of exactly this length.
  std::vector<JsonCursor> elements(std::size_t count) const;

  std::string text() const;
  std::string nonEmptyText() const;
  bool boolean() const;
  double number() const;  ///< finite
  double positiveNumber() const;
  std::uint64_t wholeNumber() const;
  Vector3 vector() const;
  Pose pose() const;  ///< as toJson(Pose) writes it; the quaternion is unit within kQuaternionNorm
  Pose row() const;   ///< as toRow writes it
  /// One of the words given, as its index.
  std::size_t oneOf(std::initializer_list<std::string_view> words) const;

 private:
  JsonCursor(const Json& value, std::string pointer) : value_(&value), pointer_(std::move(pointer)) {}
  Pose checked(const Pose& pose) const;

  const Json* value_;
  std::string pointer_;
};

}  // namespace glissade
