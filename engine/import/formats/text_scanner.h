#pragma once

#include <cstdint>
#include <string_view>

#include "engine/base/message.h"
#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads a text word by word and counts lines. Words are separated by spaces, tabs and the ends of lines (LF, CR LF or
/// CR). A byte-order mark at the beginning is skipped.
class TextScanner {
 public:
  /// `firstLine`: number of the text's first line.
  explicit TextScanner(std::string_view text, std::size_t firstLine = 1);

  /// The next word of this line; empty at the line's end.
  std::string_view wordInLine();
  /// The next word of this line or a later one; empty at the end of the text.
  std::string_view word();
  /// Moves to the beginning of the next line. False at the end of the text.
  bool nextLine();
  /// True if no word follows, on any line.
  bool atEnd();
  /// True if the text ends in the middle of a line.
  bool lastLineIsOpen() const;

  std::size_t line() const { return line_; }
  std::size_t position() const { return at_; }
  FormatError error(const Message& reason) const;

  /// The finite number in a word. `what` names it in the error: "the coordinate".
  double number(std::string_view word, CatalogueText what) const;

 private:
  bool atLineEnd() const { return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_;
};

/// A number that does not affect the surface: 0 if the word is no finite number.
float attributeNumber(std::string_view word);

/// True if the word is the keyword, in upper or lower case.
bool isKeyword(std::string_view word, std::string_view keyword);

}  // namespace glissade
