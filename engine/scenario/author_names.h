#pragma once

#include <optional>
#include <string_view>

#include "engine/planning/roadmap.h"

namespace glissade {

/// Name of an author in path files.
constexpr const char* authorName(Author author) {
  switch (author) {
    case Author::Computer: return "computer";
    case Author::Operator: return "operator";
    case Author::Contact: return "contact";
  }
  return "computer";
}

inline std::optional<Author> authorByName(std::string_view name) {
  for (const Author author : {Author::Computer, Author::Operator, Author::Contact}) {
    if (name == authorName(author)) return author;
  }
  return std::nullopt;
}

}  // namespace glissade
