#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/result.h"
#include "engine/base/work_watch.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// A value inside a JSON document together with where it is: every getter either gives what was asked
/// for or throws JsonError naming file and place. Private to the readers of files (rooms scenario and study).
class JsonCursor {
 public:
  using Json = nlohmann::ordered_json;

  JsonCursor(const Json& value, std::string file, std::string pointer)
      : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {}

  [[noreturn]] void fail(const std::string& reason, const std::string& advice = "Correct the file.") const;

  const Json& json() const { return *value_; }
  const std::string& file() const { return file_; }
  bool isString() const { return value_->is_string(); }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  void expectObject() const;
  /// An object whose keys are all among those given; anything else is an error at that key.
  void allowOnly(std::initializer_list<const char*> keys) const;
  JsonCursor at(const std::string& key) const;
  std::optional<JsonCursor> find(const std::string& key) const;

  std::size_t size() const;  ///< of an array
  JsonCursor element(std::size_t index) const;

  std::string text() const;
  std::string nonEmptyText() const;
  double number() const;
  double positiveNumber() const;
  std::uint64_t wholeNumber() const;
  bool boolean() const;
  Vector3 vector() const;
  Pose pose() const;  ///< {"position": [x,y,z], "orientation": [x,y,z,w]}

 private:
  const Json* value_;
  std::string file_;
  std::string pointer_;
};

/// Thrown by JsonCursor, caught where a document is read.
struct JsonError {
  Diagnostic diagnostic;
};

/// Parses text into a document; syntax errors name line and column. Stopped: an Interrupted error.
Result<JsonCursor::Json> parseJson(const std::string& text, const std::string& file, const WorkWatch& watch = {});
/// Parses text and gives the document to `read`, which takes a JsonCursor and may throw JsonError.
template <class Read>
auto readJson(const std::string& text, const std::string& file, const Read& read)
    -> Result<decltype(read(std::declval<const JsonCursor&>()))> {
  const auto document = parseJson(text, file);
  if (!document) return document.error();
  try {
    return read(JsonCursor(*document, file, ""));
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}
/// What a reader that was asked to stop says of its file.
Diagnostic notReadToItsEnd(const std::string& file);

/// Poses and vectors as the files have them.
JsonCursor::Json toJson(const Vector3& v);
JsonCursor::Json toJson(const Pose& pose);

}  // namespace glissade
