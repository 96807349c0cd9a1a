#include "widgets/workbench/script.h"

#include <sstream>

namespace glissade {

Result<std::vector<ScriptLine>> parseScript(const std::string& text, const std::string& file,
                                            const ScriptCommands& commands) {
  std::vector<ScriptLine> lines;
  std::istringstream stream(text);
  std::string content;
  for (int number = 1; std::getline(stream, content); ++number) {
    std::istringstream words(content);
    ScriptLine line;
    line.line = number;
    if (!(words >> line.name) || line.name.front() == '#') continue;
    for (std::string word; words >> word && word.front() != '#';) line.words.push_back(word);
    const auto count = line.name == "quit" ? std::optional<std::size_t>(0) : commands.wordCount(line.name);
    const Location place = {GLISSADE_TEXT("line %1"), {number}};
    if (!count) {
      return Diagnostic{ErrorKind::MalformedInput, file, place, Message("there is no command '" + line.name + "'"),
                        Message("Use one of " + commands.names() + ", quit.")};
    }
    if (line.words.size() != *count) {
      return Diagnostic{ErrorKind::MalformedInput, file, place,
                        Message("'" + line.name + "' takes " + std::to_string(*count) + " words"),
                        Message("Correct the line.")};
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace glissade
