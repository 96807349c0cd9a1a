#include "engine/scenario/json_cursor.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// A key as a token of a JSON pointer (RFC 6901).
std::string escaped(std::string_view key) {
  std::string token;
  for (const char c : key) {
    if (c == '~')
      token += "~0";
    else if (c == '/')
      token += "~1";
    else
      token += c;
  }
  return token;
}

std::string joined(std::initializer_list<std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

}  // namespace

void JsonCursor::fail(const std::string& reason, const std::string& advice) const {
  throw JsonFailure{{ErrorKind::MalformedInput, "", pointer_.empty() ? "/" : pointer_, reason, advice}};
}

void JsonCursor::allowOnly(std::initializer_list<std::string_view> keys) const {
  for (const auto& [key, member] : members()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      member.fail("the key '" + key + "' is unknown", "Here may be: " + joined(keys) + ".");
    }
  }
}

JsonCursor JsonCursor::at(std::string_view key) const {
  const std::optional<JsonCursor> found = find(key);
  if (!found) fail("the key '" + std::string(key) + "' is missing", "Add it.");
  return *found;
}

std::optional<JsonCursor> JsonCursor::find(std::string_view key) const {
  if (!value_->is_object()) fail("this is not an object");
  const auto found = value_->find(std::string(key));
  if (found == value_->end()) return std::nullopt;
  return JsonCursor(*found, pointer_ + "/" + escaped(key));
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const {
  if (!value_->is_object()) fail("this is not an object");
  std::vector<std::pair<std::string, JsonCursor>> result;
  for (const auto& [key, member] : value_->items()) {
    result.emplace_back(key, JsonCursor(member, pointer_ + "/" + escaped(key)));
  }
  return result;
}

std::vector<JsonCursor> JsonCursor::elements() const {
  if (!value_->is_array()) fail("this is not a list");
  std::vector<JsonCursor> result;
  for (std::size_t i = 0; i < value_->size(); ++i) {
    result.push_back(JsonCursor((*value_)[i], pointer_ + "/" + std::to_string(i)));
  }
  return result;
}

std::vector<JsonCursor> JsonCursor::elements(std::size_t count) const {
  std::vector<JsonCursor> result = elements();
  if (result.size() != count) fail("this list has not " + std::to_string(count) + " elements");
  return result;
}

std::string JsonCursor::text() const {
  if (!value_->is_string()) fail("this is not a text");
  return value_->get<std::string>();
}

std::string JsonCursor::nonEmptyText() const {
  std::string result = text();
  if (result.empty()) fail("this text is empty");
  return result;
}

bool JsonCursor::boolean() const {
  if (!value_->is_boolean()) fail("this is neither true nor false");
  return value_->get<bool>();
}

double JsonCursor::number() const {
  if (!value_->is_number()) fail("this is not a number");
  const double result = value_->get<double>();
  if (!std::isfinite(result)) fail("this is not a finite number");
  return result;
}

double JsonCursor::positiveNumber() const {
  const double result = number();
  if (result <= 0.0) fail("this number is not positive");
  return result;
}

std::uint64_t JsonCursor::wholeNumber() const {
  if (!value_->is_number_unsigned()) fail("this is not a whole number from 0 on");
  return value_->get<std::uint64_t>();
}

Vector3 JsonCursor::vector() const {
  const std::vector<JsonCursor> parts = elements(3);
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

Pose JsonCursor::pose() const {
  allowOnly({"position", "orientation"});
  const JsonCursor orientation = at("orientation");
  const std::vector<JsonCursor> q = orientation.elements(4);
  return orientation.checked(
      {at("position").vector(), Quaternion(q[3].number(), q[0].number(), q[1].number(), q[2].number())});
}

Pose JsonCursor::row() const {
  const std::vector<JsonCursor> v = elements(7);
  return checked({{v[0].number(), v[1].number(), v[2].number()},
                  Quaternion(v[6].number(), v[3].number(), v[4].number(), v[5].number())});
}

std::size_t JsonCursor::oneOf(std::initializer_list<std::string_view> words) const {
  const auto found = std::find(words.begin(), words.end(), text());
  if (found == words.end()) fail("'" + text() + "' is not known here", "Give one of: " + joined(words) + ".");
  return static_cast<std::size_t>(found - words.begin());
}

Pose JsonCursor::checked(const Pose& pose) const {
  if (!isValid(pose)) fail("the quaternion is not of length 1", "Give x, y, z, w with length 1.");
  return pose;
}

}  // namespace glissade
