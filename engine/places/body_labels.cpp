#include "engine/places/body_labels.h"

#include <algorithm>
#include <string>
#include <variant>

namespace glissade {
namespace {

bool endsInPath(const std::string& id, const std::string& path) {
  return id.size() > path.size() && id.compare(id.size() - path.size(), path.size(), path) == 0 &&
         id[id.size() - path.size() - 1] == '/';
}

/// The displayed name of the body that a text names; null if it names none.
const std::string* labelOf(const std::string& text, const std::vector<RigidBody>& bodies) {
  if (text.empty()) return nullptr;
  auto named =
      std::find_if(bodies.begin(), bodies.end(), [&](const RigidBody& body) { return body.id.text() == text; });
  if (named == bodies.end()) {
    named = std::find_if(bodies.begin(), bodies.end(),
                         [&](const RigidBody& body) { return endsInPath(body.id.text(), text); });
  }
  return named == bodies.end() ? nullptr : &named->shown();
}

void nameIn(Message& message, const std::vector<RigidBody>& bodies) {
  for (MessageArgument& argument : message.arguments) {
    if (auto* part = std::get_if<Message>(&argument.value)) {
      nameIn(*part, bodies);
    } else if (const auto* text = std::get_if<std::string>(&argument.value)) {
      if (const std::string* label = labelOf(*text, bodies)) argument = *label;
    }
  }
}

}  // namespace

void nameByLabels(Warnings& warnings, const std::vector<RigidBody>& bodies) {
  for (Diagnostic& warning : warnings) {
    nameIn(warning.location, bodies);
    nameIn(warning.reason, bodies);
  }
}

}  // namespace glissade
