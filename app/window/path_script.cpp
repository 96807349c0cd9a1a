#include "app/window/path_script.h"

#include "app/window/path_controller.h"

namespace glissade {
namespace {

Outcome outcomeOf(const std::optional<Diagnostic>& why) { return why ? Outcome(*why) : Outcome(Done{}); }

}  // namespace

std::optional<Outcome> PathScript::carryOut(const ScriptCommand& command) {
  const QString first = QString::fromStdString(command.arguments.empty() ? "" : command.arguments[0]);
  if (command.name == "export") return outcomeOf(window_.path().exportTo(first));
  if (command.name == "open-path") return outcomeOf(window_.path().open(first));
  if (command.name == "expect-path") return expect(command.arguments[0]);
  return std::nullopt;
}

Outcome PathScript::expect(const std::string& what) {
  const std::string found = window_.path().verdict();
  if (found == what) return Done{};
  return Diagnostic{ErrorKind::NoPath, "", "", "the path is '" + found + "', not '" + what + "'", ""};
}

}  // namespace glissade
