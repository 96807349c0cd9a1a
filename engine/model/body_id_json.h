#pragma once

#include "engine/base/json_formats.h"
#include "engine/model/body_id.h"

namespace glissade {

/// The id of a body as its text.
struct BodyIdFormat {
  GetterFormat<std::string> text;

  BodyId read(const JsonCursor& at) const { return BodyId(text.read(at)); }
  JsonCursor::Json write(const BodyId& id) const { return id; }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const { return text.schema(definitions); }
};
inline constexpr BodyIdFormat kBodyId{kNonEmptyText};

}  // namespace glissade
