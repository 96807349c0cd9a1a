#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace glissade {

/// Names a rigid body of a product. It is unique in the product, and stays the same as long as the body is in it. Files
/// have its text. It is neither the name that people read (RigidBody::shown()), nor a name that they write, which may
/// be the end of an id (bodiesMeant()). The rigid bodies of a file with several of them have the ids "<id>/<part>".
class BodyId {
 public:
  /// Names no body.
  BodyId() = default;
  explicit BodyId(std::string text) : text_(std::move(text)) {}
  /// A literal in the source converts without a word: it is no name of a person.
  template <std::size_t size>
  BodyId(const char (&literal)[size]) : text_(literal) {}

  const std::string& text() const { return text_; }
  /// True if it names no body.
  bool empty() const { return text_.empty(); }

  /// The order is that of the texts.
  auto operator<=>(const BodyId&) const = default;  // NOLINT(modernize-use-nullptr): it takes a 0 of the compiler
  friend std::ostream& operator<<(std::ostream& stream, const BodyId& id) { return stream << id.text_; }

 private:
  std::string text_;
};

/// The library of JSON finds it: an id is written as its text.
template <class Json>
void to_json(Json& json, const BodyId& id) {
  json = id.text();
}

/// The ids as texts, by which demands name bodies.
inline std::vector<std::string> textsOf(const std::vector<BodyId>& ids) {
  std::vector<std::string> texts;
  for (const BodyId& id : ids) texts.push_back(id.text());
  return texts;
}

}  // namespace glissade

template <>
struct std::hash<glissade::BodyId> {
  std::size_t operator()(const glissade::BodyId& id) const noexcept { return std::hash<std::string>()(id.text()); }
};
