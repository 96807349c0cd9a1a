#include "engine/study/repeat_command.h"

#include <algorithm>

#include "engine/study/study_plan.h"

namespace glissade {

std::string shellWord(const std::string& word) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string("-_./=:+").find(c) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string repeatCommand(const StudyCell& cell, std::uint64_t seed) {
  std::string command = "glissade-cli";
  for (const std::string& word : planArguments(cell, seed, cell.scenario)) command += " " + shellWord(word);
  return command;
}

}  // namespace glissade
