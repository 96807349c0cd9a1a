#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/script.h"

namespace glissade {

/// Carries out a script on a window, command by command. Offscreen the session's time goes on only in
/// `steps` and `wait`, so that the same script gives the same pictures.
class ScriptRunner {
 public:
  ScriptRunner(MainWindow& window, std::string file) : window_(window), file_(std::move(file)) {}

  /// The first thing that went wrong, or nothing.
  std::optional<Diagnostic> run(const std::vector<ScriptCommand>& commands);

 private:
  Outcome carryOut(const ScriptCommand& command);
  Outcome trigger(const ScriptCommand& command);
  Outcome setParameter(const ScriptCommand& command);
  Outcome expectValue(const ScriptCommand& command);
  Outcome key(const ScriptCommand& command);
  Outcome steps(const ScriptCommand& command);
  Outcome wait(const ScriptCommand& command);
  Outcome expect(const ScriptCommand& command);
  Outcome open(const ScriptCommand& command);
  Outcome save(const ScriptCommand& command);
  Outcome selectStrategy(const ScriptCommand& command);
  Diagnostic wrong(const ScriptCommand& command, const std::string& reason, const std::string& advice = "") const;
  /// The script is right and the session did not do what it waits for or expects.
  Diagnostic failed(const ScriptCommand& command, const std::string& reason) const;
  Diagnostic atLine(const ScriptCommand& command, Diagnostic why) const;
  bool isIn(const std::string& state) const;

  MainWindow& window_;
  std::string file_;
};

}  // namespace glissade
