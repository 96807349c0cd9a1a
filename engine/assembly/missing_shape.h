#pragma once

#include <string>
#include <vector>

namespace glissade {

/// A shape that a file states and that is no body, a product for which it states none, or a part that a scenario
/// neither names nor leaves out: proofs know nothing of it.
struct MissingShape {
  std::string file;
  std::string product;  ///< its name; empty: none
  std::string entity;   ///< "#12"; empty: it is a part, of this name
  std::string kind;     ///< as the file has it: "CSG_SOLID"
  std::string reason;   ///< "its kind is not read"

  bool operator==(const MissingShape&) const = default;
};
using MissingShapes = std::vector<MissingShape>;

/// "CSG_SOLID #12 ('pump')", "'pump'", in any language.
inline std::string nameOf(const MissingShape& shape) {
  if (shape.entity.empty()) return "'" + shape.product + "'";
  const std::string entity = shape.kind.empty() ? shape.entity : shape.kind + " " + shape.entity;
  return shape.product.empty() ? entity : entity + " ('" + shape.product + "')";
}

/// "CSG_SOLID #12 ('pump'), CSG_SOLID #14 ('pump')"; of many the first few and the number of all: "…, (12)".
inline std::string listOf(const MissingShapes& shapes) {
  constexpr std::size_t kMost = 5;
  std::string text;
  for (std::size_t i = 0; i < shapes.size() && i < kMost; ++i) text += (i > 0 ? ", " : "") + nameOf(shapes[i]);
  return shapes.size() <= kMost ? text : text + ", … (" + std::to_string(shapes.size()) + ")";
}

/// A proof states this sentence. Precondition: there are some.
inline std::string statementOf(const MissingShapes& shapes) {
  return "the proof is about the product without these shapes, which the file states: " + listOf(shapes);
}

}  // namespace glissade
