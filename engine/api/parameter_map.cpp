#include "engine/api/parameter_map.h"

#include "engine/api/values.h"

namespace glissade::api {

std::optional<Diagnostic> setAll(const Parameters& parameters, ParameterValues& values) {
  for (const auto& [key, value] : parameters) {
    const auto id = parameterByKey(key);
    if (!id) return wrongArgument("parameters", "there is no parameter '" + key + "'");
    if (const glissade::Outcome set = values.set(*id, value); !set) return publicDiagnostic(set.error());
  }
  return std::nullopt;
}

}  // namespace glissade::api
