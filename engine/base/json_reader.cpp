#include "engine/base/json_reader.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <vector>

#include "engine/base/limits.h"
#include "engine/base/printable_text.h"

namespace glissade {

using Json = JsonCursor::Json;

void JsonCursor::fail(const Message& reason, const Message& advice) const {
  throw JsonError{{ErrorKind::MalformedInput, file_, pointer_.empty() ? "/" : pointer_, reason, advice}};
}

void JsonCursor::expectObject() const {
  if (!value_->is_object()) fail(GLISSADE_TEXT("is not an object"));
}

void JsonCursor::allowOnly(std::initializer_list<const char*> keys) const {
  allowOnly(std::vector<std::string>(keys.begin(), keys.end()));
}

void JsonCursor::allowOnly(const std::vector<std::string>& keys) const {
  expectObject();
  for (const auto& item : value_->items()) {
    if (std::find(keys.begin(), keys.end(), item.key()) != keys.end()) continue;
    std::string list;
    for (const std::string& key : keys) list += (list.empty() ? "" : ", ") + key;
    at(item.key()).fail(GLISSADE_TEXT("is an unknown key"), {GLISSADE_TEXT("Remove it, or use one of: %1."), {list}});
  }
}

JsonCursor JsonCursor::at(const std::string& key) const {
  expectObject();
  const auto entry = value_->find(key);
  if (entry == value_->end()) {
    JsonCursor(*value_, file_, pointer_ + "/" + key).fail(GLISSADE_TEXT("is missing"), GLISSADE_TEXT("Add it."));
  }
  return {*entry, file_, pointer_ + "/" + key};
}

std::optional<JsonCursor> JsonCursor::find(const std::string& key) const {
  return has(key) ? std::optional<JsonCursor>(at(key)) : std::nullopt;
}

std::size_t JsonCursor::size() const {
  if (!value_->is_array()) fail(GLISSADE_TEXT("is not a list"));
  return value_->size();
}

JsonCursor JsonCursor::element(std::size_t index) const {
  return {(*value_)[index], file_, pointer_ + "/" + std::to_string(index)};
}

std::size_t JsonCursor::sizeUpTo(std::size_t most) const {
  if (size() > most) fail({GLISSADE_TEXT("has more than %1 entries"), {most}});
  return size();
}

std::string JsonCursor::text() const {
  if (!value_->is_string()) fail(GLISSADE_TEXT("is not a text"));
  return printableText(value_->get_ref<const std::string&>());
}

std::string JsonCursor::exactText() const {
  if (!value_->is_string()) fail(GLISSADE_TEXT("is not a text"));
  std::string result = value_->get<std::string>();
  if (result.empty()) fail(GLISSADE_TEXT("is empty"));
  if (result.find('\0') != std::string::npos) fail(GLISSADE_TEXT("holds a zero byte, which no file's name can"));
  return result;
}

std::string JsonCursor::nonEmptyText() const {
  std::string result = text();
  if (result.empty()) fail(GLISSADE_TEXT("is empty"));
  return result;
}

double JsonCursor::number() const {
  if (!value_->is_number()) fail(GLISSADE_TEXT("is not a number"));
  const double result = value_->get<double>();
  if (!std::isfinite(result)) fail(GLISSADE_TEXT("is not a finite number"));
  return result;
}

double JsonCursor::positiveNumber() const {
  const double result = number();
  if (result <= 0.0) fail(GLISSADE_TEXT("is not above zero"));
  return result;
}

double JsonCursor::coordinate() const {
  const double result = number();
  if (!limits::isCoordinate(result))
    fail(GLISSADE_TEXT("is beyond 1e9 m"), GLISSADE_TEXT("Give metres; check the unit."));
  return result;
}

double JsonCursor::length() const {
  const double result = positiveNumber();
  if (!limits::isSize(result))
    fail(GLISSADE_TEXT("is not from 1e-12 m to 1e9 m"), GLISSADE_TEXT("Give metres; check the unit."));
  return result;
}

std::uint64_t JsonCursor::wholeNumber() const {
  if (!value_->is_number_unsigned()) fail(GLISSADE_TEXT("is not a whole number of zero or more"));
  return value_->get<std::uint64_t>();
}

bool JsonCursor::boolean() const {
  if (!value_->is_boolean()) fail(GLISSADE_TEXT("is neither true nor false"));
  return value_->get<bool>();
}

namespace {

/// A refusal of JSON that the standard permits; the first one is reported.
struct JsonRefusal {
  Message reason;
};

/// Observes the parser: keys given twice would silently lose a value, deep documents and documents of many small values
/// would take many times their size in memory, and objects with many keys take quadratic time.
class ParserGuard {
 public:
  explicit ParserGuard(std::size_t& valuesLeft) : valuesLeft_(valuesLeft) {}

  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    constexpr int kDeepest = 32;
    if (depth > kDeepest) throw JsonRefusal{GLISSADE_TEXT("is nested too deeply")};
    const bool value = event == Event::value || event == Event::object_start || event == Event::array_start;
    if (value && valuesLeft_-- == 0) throw JsonRefusal{GLISSADE_TEXT("holds too many values")};
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key) take(parsed.get_ref<const std::string&>());
    return true;
  }

 private:
  void take(const std::string& key) {
    constexpr std::size_t kMostKeys = 20'000;
    if (!keys_.back().insert(key).second)
      throw JsonRefusal{{GLISSADE_TEXT("holds the key '%1' twice in one object"), {key}}};
    if (keys_.back().size() > kMostKeys) {
      throw JsonRefusal{{GLISSADE_TEXT("holds an object with more than %1 keys"), {kMostKeys}}};
    }
  }

  std::size_t& valuesLeft_;
  std::vector<std::set<std::string>> keys_;
};

struct Stopped {};

/// The characters of a text for the parser; checks the watch at intervals.
class WatchedText {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  WatchedText(const std::string& text, std::size_t at, const WorkWatch& watch)
      : text_(&text), watch_(&watch), at_(at) {}

  reference operator*() const { return (*text_)[at_]; }
  WatchedText& operator++() {
    constexpr std::size_t kBetweenLooks = 1U << 16;
    if (++at_ % kBetweenLooks == 0) look();
    return *this;
  }
  friend bool operator==(const WatchedText& a, const WatchedText& b) { return a.at_ == b.at_; }

 private:
  void look() const {
    if (watch_->stop.stopRequested()) throw Stopped();
    watch_->report(static_cast<double>(at_) / static_cast<double>(text_->size()));
  }

  const std::string* text_;
  const WorkWatch* watch_;
  std::size_t at_;
};

}  // namespace

Diagnostic readingStopped(const std::string& file) {
  return {ErrorKind::Interrupted, file, "", GLISSADE_TEXT("was not read to its end"), GLISSADE_TEXT("Open it again.")};
}

Result<Json> parseJson(const std::string& text, const std::string& file, const WorkWatch& watch) {
  std::size_t valuesLeft = kMostJsonValues;
  return parseJson(text, file, watch, valuesLeft);
}

Result<Json> parseJson(const std::string& text, const std::string& file, const WorkWatch& watch,
                       std::size_t& valuesLeft) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", GLISSADE_TEXT("is empty"),
                      GLISSADE_TEXT("Give a file with content.")};
  }
  try {
    ParserGuard guard(valuesLeft);
    return Json::parse(WatchedText(text, 0, watch), WatchedText(text, text.size(), watch), std::ref(guard));
  } catch (const Stopped&) {
    return readingStopped(file);
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    const std::size_t lineStart = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    const std::size_t column = lineStart == std::string::npos ? end : end - lineStart - 1;
    return Diagnostic{ErrorKind::MalformedInput,
                      file,
                      {GLISSADE_TEXT("line %1, column %2"), {line, column}},
                      GLISSADE_TEXT("is not valid JSON"),
                      GLISSADE_TEXT("Correct the text there.")};
  } catch (const JsonRefusal& refusal) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", refusal.reason, GLISSADE_TEXT("Correct the file.")};
  } catch (const Json::exception&) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", GLISSADE_TEXT("holds a number that is out of range"),
                      GLISSADE_TEXT("Correct the number.")};
  }
}

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace glissade
