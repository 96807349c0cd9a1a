#include "app/window/script.h"

#include <map>
#include <sstream>

namespace glissade {
namespace {

const std::map<std::string, std::size_t>& argumentCounts() {
  static const std::map<std::string, std::size_t> counts{{"action", 1},
                                                         {"set", 2},
                                                         {"expect-value", 2},
                                                         {"select-operator", 1},
                                                         {"key", 2},
                                                         {"steps", 1},
                                                         {"wait", 2},
                                                         {"expect", 1},
                                                         {"export", 1},
                                                         {"open-path", 1},
                                                         {"expect-path", 1},
                                                         {"screenshot", 1},
                                                         {"quit", 0},
                                                         {"open", 1},
                                                         {"save", 1},
                                                         {"select", 2},
                                                         {"click", 2},
                                                         {"drag", 4},
                                                         {"attribute", 2},
                                                         {"type", 2},
                                                         {"define", 3},
                                                         {"expect-attribute", 2},
                                                         {"expect-way", 1},
                                                         {"expect-step", 1},
                                                         {"expect-plan", 1},
                                                         {"identify", 1},
                                                         {"select-strategy", 1},
                                                         {"save-recording", 1},
                                                         {"replay", 1},
                                                         {"seek", 1},
                                                         {"expect-replay", 1},
                                                         {"plug", 2},
                                                         {"unplug", 1},
                                                         {"deflect", 7},
                                                         {"press", 2},
                                                         {"expect-steering", 1},
                                                         {"study", 1},
                                                         {"expect-difficulty", 2},
                                                         {"show-body", 2},
                                                         {"new-scenario", 3},
                                                         {"rule", 2},
                                                         {"add-part", 4},
                                                         {"place", 3},
                                                         {"expect-place", 2},
                                                         {"show-difficulty", 1},
                                                         {"study-cell", 1},
                                                         {"study-plot", 1},
                                                         {"study-zoom", 4},
                                                         {"study-save-plot", 1},
                                                         {"study-run", 2},
                                                         {"study-screenshot", 1}};
  return counts;
}

}  // namespace

Result<std::vector<ScriptCommand>> parseScript(const std::string& text, const std::string& file) {
  std::vector<ScriptCommand> commands;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::istringstream words(line);
    ScriptCommand command;
    command.line = number;
    if (!(words >> command.name) || command.name.front() == '#') continue;
    for (std::string word; words >> word && word.front() != '#';) command.arguments.push_back(word);
    const auto known = argumentCounts().find(command.name);
    const std::string place = "line " + std::to_string(number);
    if (known == argumentCounts().end()) {
      std::string names;
      for (const auto& [name, count] : argumentCounts()) names += (names.empty() ? "" : ", ") + name;
      return Diagnostic{ErrorKind::MalformedInput, file, place, "there is no command '" + command.name + "'",
                        "Use one of " + names + "."};
    }
    if (command.arguments.size() != known->second) {
      return Diagnostic{ErrorKind::MalformedInput, file, place,
                        "'" + command.name + "' takes " + std::to_string(known->second) + " words",
                        "Correct the line."};
    }
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace glissade
