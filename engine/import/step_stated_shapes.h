#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/import/step_entities.h"
#include "engine/import/step_shape_kinds.h"

namespace glissade {

/// An item of a shape as the file states it.
struct StatedShape {
  std::uint64_t entity = 0;
  std::string kind{};  ///< of the entity
  StepShapeRole role = StepShapeRole::NoMaterial;
  std::uint64_t product = 0;         ///< the PRODUCT_DEFINITION whose shape it is; 0: of none
  std::uint64_t representation = 0;  ///< that has it among its items; 0: none has
  std::uint64_t places = 1;          ///< in which the assemblies of the file have it
  /// It has triangles, and the file says that it is another representation of the product's boundaries.
  bool isSecond = false;
  /// It has triangles, and the product has boundaries, too: whether they are of the same body is not stated.
  bool mayBeSecond = false;
};

/// A product that is placed, or said to have a shape, and has none; or a use of one that is not understood.
struct StatedGap {
  std::uint64_t entity = 0;
  std::string kind{};
  std::uint64_t product = 0;  ///< as of StatedShape
  std::uint64_t places = 1;
};

/// The products and shapes that a STEP file states, counted from its own entities.
struct StatedShapes {
  std::vector<StatedShape> items;      ///< of products; without material: none
  std::vector<StatedShape> orphans;    ///< solids that belong to no product
  std::vector<StatedGap> shapeless;    ///< products
  std::vector<StatedGap> unknownUses;  ///< placements of what is no use of a product
  std::vector<StatedGap> loose;        ///< shells that belong to nothing
};

StatedShapes statedShapesOf(const StepEntities& entities);

/// A line of the protocol about an item, as "#12 (CSG_SOLID)".
std::string stepShapeLine(char kind, const StatedShape& item, const std::string& what);

/// The PRODUCT of a PRODUCT_DEFINITION; 0 where it has none.
std::uint64_t productOfDefinition(const StepEntities& entities, std::uint64_t definition);

}  // namespace glissade
