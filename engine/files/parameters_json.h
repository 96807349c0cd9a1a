#pragma once

#include <map>

#include "engine/base/json_formats.h"
#include "engine/base/parameters.h"

namespace glissade {

/// The parameter of a key. Throws JsonError at `at`.
ParameterId parameterNamed(const std::string& key, const JsonCursor& at);

/// Parameters by their keys, with any finite values. Reading throws JsonError.
struct ParametersFormat {
  std::map<ParameterId, double> read(const JsonCursor& at) const;
  JsonCursor::Json write(const std::map<ParameterId, double>& values) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

/// A parameter as its key.
struct ParameterKeyFormat {
  ParameterId read(const JsonCursor& at) const;
  JsonCursor::Json write(ParameterId id) const { return std::string(specOf(id).key); }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

}  // namespace glissade
