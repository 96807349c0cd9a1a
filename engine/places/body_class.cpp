#include "engine/places/body_class.h"

#include <algorithm>

namespace glissade {
namespace {

Diagnostic refusedClass(const Message& reason, const Message& advice) {
  return {ErrorKind::MalformedInput, "", "", reason, advice};
}

}  // namespace

Result<BodyClasses> BodyClasses::of(const std::vector<BodyClass>& classes) {
  BodyClasses tree;
  for (const BodyClass& each : classes) {
    const auto same = std::find_if(tree.classes_.begin(), tree.classes_.end(),
                                   [&](const BodyClass& other) { return other.name == each.name; });
    if (same == tree.classes_.end()) {
      tree.classes_.push_back(each);
    } else {
      *same = each;
    }
  }
  for (const BodyClass& each : tree.classes_) {
    std::size_t ancestors = 0;
    for (const BodyClass* at = &each; !at->of.empty(); ++ancestors) {
      if (ancestors == tree.classes_.size()) {
        return refusedClass({GLISSADE_TEXT("the parents of the class '%1' form a cycle"), {each.name}},
                            GLISSADE_TEXT("Correct 'of'."));
      }
      const BodyClass* parent = tree.find(at->of);
      if (parent == nullptr) {
        return refusedClass({GLISSADE_TEXT("the class '%1' is of '%2', which is not a class"), {at->name, at->of}},
                            GLISSADE_TEXT("Correct 'of'."));
      }
      at = parent;
    }
  }
  return tree;
}

const BodyClass* BodyClasses::find(const std::string& name) const {
  const auto found =
      std::find_if(classes_.begin(), classes_.end(), [&](const BodyClass& each) { return each.name == name; });
  return found == classes_.end() ? nullptr : &*found;
}

Attributes BodyClasses::attributesOf(const std::string& name) const {
  Attributes attributes;
  for (const BodyClass* at = find(name); at != nullptr; at = find(at->of)) {
    attributes.insert(at->attributes.begin(), at->attributes.end());
  }
  return attributes;
}

std::string BodyClasses::fastenerOf(const std::string& name) const {
  for (const BodyClass* at = find(name); at != nullptr; at = find(at->of)) {
    if (!at->fastener.empty()) return at->fastener;
  }
  return {};
}

}  // namespace glissade
