#include "engine/import/formats/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace glissade {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool endsWord(char c) { return isBlank(c) || c == '\n' || c == '\r'; }

}  // namespace

TextScanner::TextScanner(std::string_view text, std::size_t firstLine) : text_(text), line_(firstLine) {
  if (text_.substr(0, kByteOrderMark.size()) == kByteOrderMark) at_ = kByteOrderMark.size();
}

std::string_view TextScanner::wordInLine() {
  while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  while (at_ < text_.size() && !endsWord(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextScanner::word() {
  std::string_view found = wordInLine();
  while (found.empty() && nextLine()) found = wordInLine();
  return found;
}

bool TextScanner::nextLine() {
  while (!atLineEnd()) ++at_;
  if (at_ == text_.size()) return false;
  at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
  ++line_;
  return true;
}

bool TextScanner::atEnd() {
  return std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(), endsWord);
}

bool TextScanner::lastLineIsOpen() const { return !text_.empty() && text_.back() != '\n' && text_.back() != '\r'; }

FormatError TextScanner::error(const Message& reason) const { return {{GLISSADE_TEXT("line %1"), {line_}}, reason}; }

double TextScanner::number(std::string_view word, CatalogueText what) const {
  if (word.empty()) throw error({GLISSADE_TEXT("ends before %1"), {what}});
  const std::string_view digits = word.front() == '+' ? word.substr(1) : word;
  double value = 0.0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // Out of range are numbers that overflow, and numbers too close to zero.
  if (fault == std::errc::result_out_of_range) value = std::strtod(std::string(digits).c_str(), nullptr);
  const bool whole = fault != std::errc::invalid_argument && end == digits.data() + digits.size();
  if (!whole || digits.front() == '+') {
    throw error({GLISSADE_TEXT("%1 %2 is not a number"), {what, inQuotes(word)}});
  }
  if (!std::isfinite(value)) {
    throw error({GLISSADE_TEXT("%1 %2 is not a finite number"), {what, inQuotes(word)}});
  }
  return value;
}

float attributeNumber(std::string_view word) {
  float value = 0.0F;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return std::isfinite(value) ? value : 0.0F;
}

bool isKeyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

}  // namespace glissade
