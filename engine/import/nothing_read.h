#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "engine/import/import_protocol.h"

namespace glissade {

/// The reason why a file gives no body: "it holds neither a solid nor a face: #12 CSG_SOLID: its kind is not read",
/// with the first missing shape in these lines of the protocol.
inline std::string nothingRead(const std::vector<std::string>& notes) {
  const std::string nothing = "it holds neither a solid nor a face";
  const auto missing = std::find_if(notes.begin(), notes.end(), [](const std::string& line) {
    return line.front() == import_protocol::kMissingLine;
  });
  if (missing == notes.end()) return nothing;
  std::string text = missing->substr(missing->find('\t', 2) + 1);
  text.replace(text.rfind('\t'), 1, ": ");
  std::replace(text.begin(), text.end(), '\t', ' ');
  return nothing + ": " + text;
}

}  // namespace glissade
