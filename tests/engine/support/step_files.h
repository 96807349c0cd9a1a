#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "tests/engine/support/directories.h"

namespace glissade::test {

/// One of the files that tests/step_files writes.
inline std::string stepFile(const std::string& name) { return stepFileDirectory() + "/" + name; }

inline std::string stepText(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(stepFile(name)).rdbuf();
  return text.str();
}

/// The text with every `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace glissade::test
