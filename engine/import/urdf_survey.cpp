#include "engine/import/urdf_survey.h"

#include <expat.h>

#include <memory>

namespace glissade {
namespace {

constexpr int kDeepestElement = 32;
constexpr std::size_t kMostElements = 20'000;

struct Survey {
  XML_Parser parser = nullptr;
  UrdfSurvey result;
  int depth = 0;
  std::size_t elements = 0;
  bool inLink = false;
  std::string refusal;

  void refuse(const std::string& reason) {
    refusal = reason;
    XML_StopParser(parser, XML_FALSE);
  }
};

std::string attribute(const XML_Char** attributes, std::string_view name) {
  for (; *attributes; attributes += 2) {
    if (attributes[0] == name) return attributes[1];
  }
  return {};
}

void onStart(void* data, const XML_Char* element, const XML_Char** attributes) {
  Survey& survey = *static_cast<Survey*>(data);
  const std::string_view name = element;
  const int depth = ++survey.depth;
  if (depth > kDeepestElement) return survey.refuse("elements are nested too deeply");
  if (++survey.elements > kMostElements) return survey.refuse("there are too many elements");
  if (depth == 1 && name != "robot")
    return survey.refuse("the root element is <" + std::string(name) + ">, not <robot>");
  if (depth == 2) {
    survey.inLink = name == "link";
    if (survey.inLink) survey.result.links.push_back({attribute(attributes, "name"), 0, 0});
    if (name == "joint") ++survey.result.joints;
  }
  if (depth == 3 && survey.inLink) {
    if (name == "collision") ++survey.result.links.back().collisions;
    if (name == "visual") ++survey.result.links.back().visuals;
  }
}

void onEnd(void* data, const XML_Char*) { --static_cast<Survey*>(data)->depth; }

void onDoctype(void* data, const XML_Char*, const XML_Char*, const XML_Char*, int) {
  static_cast<Survey*>(data)->refuse("document type declarations are not allowed");
}

}  // namespace

Result<UrdfSurvey> surveyUrdf(std::string_view xml) {
  // The encoding given here overrides the file's own declaration: urdfdom knows only UTF-8.
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate("UTF-8"), &XML_ParserFree);
  Survey survey;
  survey.parser = parser.get();
  XML_SetUserData(parser.get(), &survey);
  XML_SetElementHandler(parser.get(), onStart, onEnd);
  XML_SetStartDoctypeDeclHandler(parser.get(), onDoctype);
  if (XML_Parse(parser.get(), xml.data(), static_cast<int>(xml.size()), XML_TRUE) == XML_STATUS_OK) {
    return survey.result;
  }
  const std::string place = "line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) + ", column " +
                            std::to_string(XML_GetCurrentColumnNumber(parser.get()) + 1);
  const std::string reason = survey.refusal.empty() ? std::string("the XML is broken (") +
                                                          XML_ErrorString(XML_GetErrorCode(parser.get())) + ")"
                                                    : survey.refusal;
  return Diagnostic{ErrorKind::MalformedInput, "", place, reason, "Mend the file there."};
}

}  // namespace glissade
