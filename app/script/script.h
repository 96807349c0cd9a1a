#pragma once

#include <string>
#include <vector>

#include "app/script/script_commands.h"

namespace glissade {

/// One line of a script: what to do, with its words.
struct ScriptLine {
  int line = 0;  ///< in the file, from 1
  std::string name;
  std::vector<std::string> words;
};

/// Parses a script: one command a line; a word that begins with '#' and what follows is a comment; "quit" ends the
/// script. Errors are MalformedInput naming file and line: unknown command, wrong number of words.
Result<std::vector<ScriptLine>> parseScript(const std::string& text, const std::string& file,
                                            const ScriptCommands& commands);

}  // namespace glissade
