#include "engine/import/iges_text_check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace glissade {
namespace {

constexpr std::size_t kSectionColumn = 72;
/// Start, global, directory, parameters, terminate.
constexpr std::string_view kSections = "SGDPT";

/// The number in a text with blanks around it; nothing if it is none.
std::optional<std::size_t> numberIn(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  text = text.substr(first, text.find_last_not_of(' ') + 1 - first);
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string_view withoutReturn(std::string_view line) { return line.substr(0, std::min(line.find('\r'), line.size())); }

class IgesTextCheck {
 public:
  std::optional<Message> faultOf(std::string_view text) {
    for (std::size_t begin = 0; begin < text.size() && section_ + 1 < kSections.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      if (auto fault = faultOfLine(text.substr(begin, end - begin))) return fault;
      begin = end + 1;
    }
    if (section_ + 1 < kSections.size()) {
      return GLISSADE_TEXT("it ends before its terminate section (T): it is cut off");
    }
    return std::nullopt;
  }

 private:
  std::optional<Message> faultOfLine(std::string_view line) {
    ++line_;
    const std::size_t found =
        line.size() > kSectionColumn ? kSections.find(line[kSectionColumn]) : std::string_view::npos;
    if (line_ == 1 && found != 0) {
      return GLISSADE_TEXT("column 73 of its first line is not S: it is no text of 80 columns");
    }
    if (found == std::string_view::npos || found < section_ || found > section_ + 1) {
      return Message(GLISSADE_TEXT("its line %1 is of no section, or of another one than the lines around it"),
                     {line_});
    }
    section_ = found;
    ++lines_[section_];
    if (numberIn(withoutReturn(line.substr(kSectionColumn + 1))) != lines_[section_]) {
      return Message(GLISSADE_TEXT("its line %1 is not numbered as it should be (%2): lines are missing, or damaged"),
                     {line_, kSections[section_] + std::to_string(lines_[section_])});
    }
    return kSections[section_] == 'T' ? faultOfCounts(line) : std::nullopt;
  }

  /// Checks the counts in "S0000001G0000003D0000010P0000009"; a missing count is permitted.
  std::optional<Message> faultOfCounts(std::string_view line) const {
    constexpr std::size_t kField = 8;
    for (std::size_t i = 0; i + 1 < kSections.size(); ++i) {
      const std::string_view field = line.substr(i * kField, kField);
      const auto stated = field.front() == kSections[i] ? numberIn(field.substr(1)) : std::nullopt;
      if (!stated || *stated == lines_[i]) continue;
      return Message(GLISSADE_TEXT("it has %1 {1|line|lines} in its section %2, and states %3: lines are missing"),
                     {lines_[i], std::string(1, kSections[i]), *stated});
    }
    return std::nullopt;
  }

  std::size_t line_ = 0;
  std::size_t section_ = 0;
  std::array<std::size_t, kSections.size()> lines_{};
};

}  // namespace

std::optional<Message> faultOfIgesText(std::string_view text) { return IgesTextCheck().faultOf(text); }

}  // namespace glissade
