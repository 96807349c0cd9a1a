#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/base/result.h"
#include "engine/base/work_watch.h"

namespace glissade {

/// A value inside a JSON document together with where it is: every getter either gives what was asked
/// for or throws JsonError naming file and location.
class JsonCursor {
 public:
  using Json = nlohmann::ordered_json;

  JsonCursor(const Json& value, std::string file, std::string pointer)
      : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {}

  [[noreturn]] void fail(const Message& reason, const Message& advice = GLISSADE_TEXT("Correct the file.")) const;

  const Json& json() const { return *value_; }
  const std::string& file() const { return file_; }
  const std::string& pointer() const { return pointer_; }
  bool isString() const { return value_->is_string(); }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  void expectObject() const;
  /// Checks that the value is an object with keys among these only; the error is at the first other key.
  void allowOnly(std::initializer_list<const char*> keys) const;
  void allowOnly(const std::vector<std::string>& keys) const;
  JsonCursor at(const std::string& key) const;
  std::optional<JsonCursor> find(const std::string& key) const;

  std::size_t size() const;  ///< length of an array
  JsonCursor element(std::size_t index) const;

  std::size_t sizeUpTo(std::size_t most) const;  ///< length of an array, which may not exceed `most`

  std::string text() const;  ///< printable: see printableText()
  std::string nonEmptyText() const;
  std::string exactText() const;  ///< a file's path; not empty
  double number() const;
  double positiveNumber() const;
  double coordinate() const;  ///< metres, at most limits::kLargestLength in magnitude
  double length() const;      ///< a size in metres, within the limits
  std::uint64_t wholeNumber() const;
  bool boolean() const;
  /// The value of an enumeration by its name. Any other text is an error that lists the names.
  template <class Enum, std::size_t count>
  Enum named(const EnumNames<Enum, count>& names) const {
    if (const auto value = names.find(text())) return *value;
    fail({GLISSADE_TEXT("is not one of: %1"), {names.listed()}});
  }

 private:
  const Json* value_;
  std::string file_;
  std::string pointer_;
};

/// Thrown by JsonCursor, caught where a document is read.
struct JsonError {
  Diagnostic diagnostic;
};

/// Limit of the values in the documents of one file: 20 million of the largest kind take 1.3 GB.
inline constexpr std::size_t kMostJsonValues = 20'000'000;

/// Parses text into a document; syntax errors name line and column. Refused: nesting deeper than 32, a key given twice
/// in an object, more than 20,000 keys in an object (a look-up is linear), more values than `valuesLeft`, from which
/// the values read are subtracted. After a stop: an Interrupted error.
Result<JsonCursor::Json> parseJson(const std::string& text, const std::string& file, const WorkWatch& watch,
                                   std::size_t& valuesLeft);
Result<JsonCursor::Json> parseJson(const std::string& text, const std::string& file, const WorkWatch& watch = {});

/// The text of a document, which is always valid UTF-8 (U+FFFD replaces invalid bytes). `indent` -1: on one line.
std::string jsonText(const JsonCursor::Json& json, int indent = -1);

/// Parses text and passes the document to `read`, which takes a JsonCursor and may throw JsonError.
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
/// The error for a file whose reading was stopped.
Diagnostic readingStopped(const std::string& file);

}  // namespace glissade
