#pragma once

#include <initializer_list>
#include <optional>
#include <string>

namespace glissade {

/// Builds a CSV text (RFC 4180, but lines end in LF): first the header, then rows.
class CsvTable {
 public:
  void header(std::initializer_list<std::string> names);
  void row();
  void text(const std::string& value);
  /// The shortest text that reads back as this number, without an exponent; empty where there is none.
  void number(std::optional<double> value);

  /// The text, with the end of its last line.
  std::string content() const { return content_ + "\n"; }

 private:
  void separate();

  std::string content_;
  bool atLineStart_ = true;
};

}  // namespace glissade
