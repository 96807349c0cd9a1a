#include "engine/study/study_json.h"

#include <cmath>

#include "engine/study/finding_reader.h"

namespace glissade::study_json {

Json number(double value) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (value == std::floor(value) && std::abs(value) <= kExact) return static_cast<std::int64_t>(value);
  return value;
}

Json parameters(const std::map<ParameterId, double>& values) {
  Json json = Json::object();
  for (const auto& [id, value] : values) json[std::string(specOf(id).key)] = number(value);
  return json;
}

Json paper(const std::map<std::string, PaperValue>& values) {
  Json json = Json::object();
  for (const auto& [key, value] : values) {
    if (const auto* printed = std::get_if<double>(&value)) json[key] = number(*printed);
    if (const auto* words = std::get_if<std::string>(&value)) json[key] = *words;
  }
  return json;
}

void addHeading(Json& json, const StudyHeading& heading) {
  json["name"] = heading.name;
  json["title"] = heading.title;
  json["description"] = heading.description;
  json["citation"] = heading.citation;
  json["paper"] = Json::array();
  for (const PaperColumn& column : heading.paper) {
    json["paper"].push_back({{"key", column.key},
                             {"title", column.title},
                             {"measure", column.quantity.measure},
                             {"statistic", column.quantity.statistic},
                             {"over", column.quantity.over}});
  }
  json["findings"] = Json::array();
  for (const Finding& finding : heading.findings) json["findings"].push_back(toJson(finding));
}

}  // namespace glissade::study_json
