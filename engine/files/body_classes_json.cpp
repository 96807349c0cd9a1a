#include "engine/files/body_classes_json.h"

#include <glissade/body_classes.h>

#include "engine/files/semantics_json.h"
#include "engine/sequence/fastener_kind.h"

namespace glissade {
namespace {

/// A body class names its kind of fastener by text; empty: none is stated.
constexpr Accessor kFastener{[](const BodyClass& of) { return kFastenerNames.find(of.fastener); },
                             [](BodyClass& of, FastenerKind kind) { of.fastener = kFastenerNames.of(kind); }};

}  // namespace

template <class Archive>
void describe(Archive& each, Type<BodyClass> /*type*/) {
  each.type("body_class");
  each.required("name", &BodyClass::name, kNonEmptyText);
  each.optional("of", &BodyClass::of, kNonEmptyText, "The class that it inherits from.");
  each.optional("label", &BodyClass::label, kText);
  each.optional("fastener", kFastener, named(kFastenerNames));
  each.optional("attributes", &BodyClass::attributes, AttributesFormat());
}

template struct ObjectFormat<BodyClass>;

std::vector<BodyClass> usualBodyClasses() {
  const auto read = readJson(kUsualBodyClassesText, "body_classes.json", [](const JsonCursor& at) {
    at.allowOnly({"format", "version", "description", "classes"});
    return kBodyClasses.read(at.at("classes"));
  });
  return read ? *read : std::vector<BodyClass>();
}

}  // namespace glissade
