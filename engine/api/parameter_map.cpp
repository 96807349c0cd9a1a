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

Parameters publicParameters(const ParameterValues& values) {
  Parameters all;
  for (const ParameterSpec& spec : parameterTable()) all.emplace(spec.key, values[spec.id]);
  return all;
}

}  // namespace glissade::api
