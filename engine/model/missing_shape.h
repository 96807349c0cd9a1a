#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"

namespace glissade {

/// A stated shape that is no body, a product without a stated shape, or a part that a scenario neither names nor leaves
/// out. Proofs do not include it.
struct MissingShape {
  std::string file;
  std::string product;  ///< name of the product; empty: none
  std::string entity;   ///< "#12"; empty: it is the part `product`
  std::string kind;     ///< kind in the file: "CSG_SOLID"
  Message reason;       ///< "its kind is not read"

  bool operator==(const MissingShape&) const = default;
};
using MissingShapes = std::vector<MissingShape>;

/// "CSG_SOLID #12 ('pump')", "'pump'", in any language.
inline std::string nameOf(const MissingShape& shape) {
  if (shape.entity.empty()) return "'" + shape.product + "'";
  const std::string entity = shape.kind.empty() ? shape.entity : shape.kind + " " + shape.entity;
  return shape.product.empty() ? entity : entity + " ('" + shape.product + "')";
}

/// "CSG_SOLID #12 ('pump'), CSG_SOLID #14 ('pump')"; for many shapes the first few and the number of all: "…, (12)".
inline std::string listOf(const MissingShapes& shapes) {
  constexpr std::size_t kMost = 5;
  std::string text;
  for (std::size_t i = 0; i < shapes.size() && i < kMost; ++i) text += (i > 0 ? ", " : "") + nameOf(shapes[i]);
  return shapes.size() <= kMost ? text : text + ", … (" + std::to_string(shapes.size()) + ")";
}

/// The sentence that a proof states. Precondition: there are missing shapes.
inline Message statementOf(const MissingShapes& shapes) {
  return {GLISSADE_TEXT("the certificate is about the product without these shapes, which the file states: %1"),
          {listOf(shapes)}};
}

}  // namespace glissade
