#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/import/step_entities.h"
#include "engine/import/step_note.h"
#include "engine/import/step_shape_kinds.h"

namespace glissade {

/// An item of a shape, as the file states it.
struct StatedShape {
  std::uint64_t entity = 0;
  std::string kind{};  ///< kind of the entity
  StepShapeRole role = StepShapeRole::NoMaterial;
  std::uint64_t product = 0;         ///< the PRODUCT_DEFINITION of the shape; 0: none
  std::uint64_t representation = 0;  ///< the representation with this item; 0: none
  std::uint64_t places = 1;          ///< number of places in the assemblies of the file
  /// The item has triangles, and the file states that they are another representation of the product's boundaries.
  bool isSecond = false;
  /// The item has triangles, and the product also has boundaries; the file does not state whether they are the same
  /// body.
  bool mayBeSecond = false;
};

/// A product that is placed or has a shape by statement, but has no shape; or a use that is not understood.
struct StatedGap {
  std::uint64_t entity = 0;
  std::string kind{};
  std::uint64_t product = 0;  ///< see StatedShape::product
  std::uint64_t places = 1;
};

/// The products and shapes that a STEP file states, counted by its entities.
struct StatedShapes {
  std::vector<StatedShape> items;      ///< items of products, except those without material
  std::vector<StatedShape> orphans;    ///< solids without a product
  std::vector<StatedGap> shapeless;    ///< products
  std::vector<StatedGap> unknownUses;  ///< placements that are no use of a product
  std::vector<StatedGap> loose;        ///< shells without an owner
};

StatedShapes statedShapesOf(const StepEntities& entities);

/// A note about an item, such as "#12 (CSG_SOLID)".
StepNote stepShapeNote(char kind, const StatedShape& item, const Message& what);

/// The PRODUCT of a PRODUCT_DEFINITION; 0 if it has none.
std::uint64_t productOfDefinition(const StepEntities& entities, std::uint64_t definition);

}  // namespace glissade
