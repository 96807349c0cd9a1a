#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/file_save.h"
#include "engine/base/result.h"

namespace glissade {

/// The commands that a script can give, by name. Controllers add their commands in their constructors (README.md lists
/// all commands).
class ScriptCommands {
 public:
  using Words = std::vector<std::string>;
  /// Carries a command out. Errors name no file and line.
  using Handler = std::function<Outcome(const Words&)>;

  /// `words`: the number of words after the name.
  void add(const std::string& name, std::size_t words, Handler handler);
  /// Nothing if there is no such command.
  std::optional<std::size_t> wordCount(const std::string& name) const;
  /// "action, attribute, ..."
  std::string names() const;
  /// Precondition: the command exists and takes this number of words.
  Outcome carryOut(const std::string& name, const Words& words) const { return commands_.at(name).handler(words); }

 private:
  struct Entry {
    std::size_t words;
    Handler handler;
  };
  std::map<std::string, Entry> commands_;
};

/// The script is wrong. Scripts and what is said about them are English.
inline Diagnostic wrongCommand(const std::string& reason, const std::string& advice = "Correct the line.") {
  return {ErrorKind::MalformedInput, "", "", Message(reason), Message(advice)};
}

/// The script is right, but the window's state differs from what it expects.
inline Diagnostic unmetExpectation(const std::string& reason) {
  return {ErrorKind::NoPath, "", "", Message(reason), {}};
}

inline Outcome outcomeOf(const std::optional<Diagnostic>& why) { return why ? Outcome(*why) : Outcome(Done{}); }
inline Outcome outcomeOf(const SaveResult& saved) { return saved ? Outcome(Done{}) : Outcome(saved.why); }

}  // namespace glissade
