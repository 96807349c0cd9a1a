#include "engine/import/missing_shapes_json.h"

#include <nlohmann/json.hpp>

#include "engine/base/printable_text.h"

namespace glissade {

nlohmann::ordered_json missingShapesJson(const MissingShapes& shapes) {
  auto list = nlohmann::ordered_json::array();
  for (const MissingShape& shape : shapes) {
    list.push_back({{"file", printableLine(shape.file)},
                    {"product", shape.product},
                    {"entity", shape.entity},
                    {"kind", shape.kind},
                    {"reason", toString(shape.reason)}});
  }
  return list;
}

}  // namespace glissade
