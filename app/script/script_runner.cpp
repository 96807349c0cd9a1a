#include "app/script/script_runner.h"

#include <QCoreApplication>
#include <QEvent>

namespace glissade {

namespace {

Diagnostic atLine(const Diagnostic& why, const std::string& file, const ScriptLine& line) {
  const std::string detail = why.location.empty() ? "" : why.location + ": ";
  return {why.kind, file, "line " + std::to_string(line.line), detail + why.reason, why.advice};
}

}  // namespace

std::optional<Diagnostic> runScript(const std::vector<ScriptLine>& lines, const std::string& file,
                                    const ScriptCommands& commands, const TakeFailure& takeFailure) {
  for (const ScriptLine& line : lines) {
    if (line.name == "quit") break;
    const Outcome outcome = commands.carryOut(line.name, line.words);
    if (!outcome) return atLine(outcome.error(), file, line);
    QCoreApplication::processEvents();
    // Only the application's own event loop would delete these objects, and a script runs inside it.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    if (const auto why = takeFailure()) return atLine(*why, file, line);
  }
  return std::nullopt;
}

}  // namespace glissade
