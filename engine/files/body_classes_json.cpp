#include "engine/files/body_classes_json.h"

#include <glissade/body_classes.h>

#include "engine/base/limits.h"
#include "engine/files/semantics_json.h"
#include "engine/sequence/fastener_kind.h"

namespace glissade {
namespace {

BodyClass readBodyClass(const JsonCursor& at) {
  at.allowOnly({"name", "of", "label", "fastener", "attributes"});
  BodyClass read{at.at("name").nonEmptyText()};
  if (const auto of = at.find("of")) read.of = of->nonEmptyText();
  if (const auto label = at.find("label")) read.label = label->text();
  if (const auto fastener = at.find("fastener")) read.fastener = kFastenerNames.of(fastener->named(kFastenerNames));
  read.attributes = readAttributes(at.find("attributes"));
  return read;
}

}  // namespace

std::vector<BodyClass> readBodyClasses(const JsonCursor& at) {
  std::vector<BodyClass> classes;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) classes.push_back(readBodyClass(at.element(i)));
  return classes;
}

JsonCursor::Json toJson(const BodyClass& bodyClass) {
  JsonCursor::Json json{{"name", bodyClass.name}};
  if (!bodyClass.of.empty()) json["of"] = bodyClass.of;
  if (!bodyClass.label.empty()) json["label"] = bodyClass.label;
  if (!bodyClass.fastener.empty()) json["fastener"] = bodyClass.fastener;
  if (!bodyClass.attributes.empty()) json["attributes"] = attributesToJson(bodyClass.attributes);
  return json;
}

std::vector<BodyClass> usualBodyClasses() {
  const auto read = readJson(kUsualBodyClassesText, "body_classes.json", [](const JsonCursor& at) {
    at.allowOnly({"format", "version", "description", "classes"});
    return readBodyClasses(at.at("classes"));
  });
  return read ? *read : std::vector<BodyClass>();
}

}  // namespace glissade
