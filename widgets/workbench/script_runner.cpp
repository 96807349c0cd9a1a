#include "widgets/workbench/script_runner.h"

#include <QCoreApplication>
#include <QEvent>

namespace glissade {

namespace {

Diagnostic atLine(const Diagnostic& why, const std::string& file, const ScriptLine& line) {
  const Message reason =
      why.location.empty() ? why.reason : Message(GLISSADE_TEXT("%1: %2"), {why.location, why.reason});
  return {why.kind, file, {GLISSADE_TEXT("line %1"), {line.line}}, reason, why.advice};
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
