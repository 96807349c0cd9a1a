#pragma once

#include <string>
#include <vector>

#include "widgets/workbench/script_commands.h"

namespace glissade {

/// One line of a script: a command and its words.
struct ScriptLine {
  int line = 0;  ///< line number in the file, from 1
  std::string name;
  std::vector<std::string> words;
};

/// Parses a script. Each line holds one command; a word that begins with '#' starts a comment; "quit" ends the script.
/// Errors are MalformedInput with file and line: unknown command, wrong number of words.
Result<std::vector<ScriptLine>> parseScript(const std::string& text, const std::string& file,
                                            const ScriptCommands& commands);

}  // namespace glissade
