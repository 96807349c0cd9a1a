#include "engine/files/parameters_json.h"

namespace glissade {

ParameterId parameterNamed(const std::string& key, const JsonCursor& at) {
  const auto id = parameterByKey(key);
  if (!id) {
    at.fail(GLISSADE_TEXT("is not a parameter"), GLISSADE_TEXT("Remove it, or see 'glissade-cli plan --help'."));
  }
  return *id;
}

std::map<ParameterId, double> ParametersFormat::read(const JsonCursor& at) const {
  at.expectObject();
  std::map<ParameterId, double> values;
  for (const auto& item : at.json().items()) {
    const JsonCursor value = at.at(item.key());
    values[parameterNamed(item.key(), value)] = value.number();
  }
  return values;
}

JsonCursor::Json ParametersFormat::write(const std::map<ParameterId, double>& values) const {
  JsonCursor::Json json = JsonCursor::Json::object();
  for (const auto& [id, value] : values) json[std::string(specOf(id).key)] = value;
  return json;
}

JsonCursor::Json ParametersFormat::schema(SchemaDefinitions& /*definitions*/) const {
  JsonCursor::Json properties = JsonCursor::Json::object();
  for (const ParameterSpec& spec : parameterTable()) {
    const double least = spec.scale == ParameterScale::Absolute ? spec.minimum : 0.0;
    properties[std::string(spec.key)] = {{"type", "number"}, {"minimum", least}};
  }
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

ParameterId ParameterKeyFormat::read(const JsonCursor& at) const { return parameterNamed(at.text(), at); }

JsonCursor::Json ParameterKeyFormat::schema(SchemaDefinitions& /*definitions*/) const {
  JsonCursor::Json keys = JsonCursor::Json::array();
  for (const ParameterSpec& spec : parameterTable()) keys.push_back(std::string(spec.key));
  return {{"enum", std::move(keys)}};
}

}  // namespace glissade
