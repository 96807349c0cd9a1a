#pragma once

#include <string>
#include <string_view>

namespace glissade {

/// A text from a file, a file's name or the environment in a displayable form: valid UTF-8, in which U+FFFD replaces
/// every invalid byte, every control character except line feed and tab, and every character that reorders or breaks
/// the line around it (bidirectional embeddings, overrides and isolates; line and paragraph separator).
std::string printableText(std::string_view text);

/// printableText() on one line: U+FFFD replaces line feed and tab as well.
std::string printableLine(std::string_view text);

}  // namespace glissade
