#include "engine/import/step_text_check.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>
#include <vector>

#include "engine/import/step_references.h"
#include "engine/import/step_shape_kinds.h"

namespace glissade {
namespace {

constexpr std::size_t kLongestNumber = 350;
constexpr std::size_t kMostParentheses = 100;
constexpr std::size_t kLongestList = 100'000;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

bool beginsNumber(char c) { return isDigit(c) || c == '+' || c == '-'; }

bool isOfNumber(char c) { return beginsNumber(c) || c == '.' || c == 'E' || c == 'e'; }

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

bool isOfWord(char c) { return isLetter(c) || isDigit(c) || c == '-'; }

/// Precondition: not longer than kLongestNumber.
bool isFinite(std::string_view number) {
  constexpr std::size_t kFewDigits = 300;
  if (number.front() == '+') number.remove_prefix(1);
  double value = 0.0;
  const auto result = std::from_chars(number.data(), number.data() + number.size(), value);
  if (result.ec != std::errc::result_out_of_range) return true;
  // A number that is too small for a double is read as zero.
  const std::size_t exponent = number.find_first_of("Ee");
  return exponent < kFewDigits && number.substr(exponent + 1, 1) == "-";
}

/// Checks the tokens of the text in their order.
class StepTextCheck {
 public:
  explicit StepTextCheck(std::string_view text) : text_(text) {}

  std::optional<Message> fault() {
    while (at_ < text_.size() && !fault_) checkToken();
    if (fault_) return fault_;
    const auto reference = references_.fault();
    if (reference) failAt(reference->at, reference->reason);
    return fault_;
  }

 private:
  void checkToken() {
    const char c = text_[at_];
    if (c == '\'' || c == '"') {
      skipTo(text_.find(c, at_ + 1), 1);
    } else if (text_.compare(at_, 2, "/*") == 0) {
      skipTo(text_.find("*/", at_ + 2), 2);
    } else if (c == '#') {
      takeReference();
    } else if (c == '.' && !isDigitAt(at_ + 1)) {
      at_ = endOf(isOfWord, at_ + 1);  // an enumeration
    } else if (isLetter(c)) {
      checkWord();
    } else if (beginsNumber(c) || c == '.') {
      checkNumber();
    } else {
      checkDelimiter(c);
      ++at_;
    }
  }

  /// `#12=TYPE` begins an entity; every other `#12` is a reference.
  void takeReference() {
    const std::size_t begin = at_;
    at_ = endOf(isOfWord, at_ + 1);
    std::uint64_t id = 0;
    const auto [end, error] = std::from_chars(text_.data() + begin + 1, text_.data() + at_, id);
    if (error != std::errc() || end != text_.data() + at_) return;
    const std::size_t next = endOf(isSpace, at_);
    if (!valuesOfList_.empty() || next == text_.size() || text_[next] != '=') {
      references_.refer(id);
      return;
    }
    const std::size_t type = endOf(isSpace, next + 1);
    const std::string_view kind = text_.substr(type, endOf(isOfWord, type) - type);
    references_.beginEntity(id, begin, kind);
    isTessellation_ = holdsTessellation(kind);
    at_ = next;
  }

  void checkDelimiter(char c) {
    if (c == ';' && !valuesOfList_.empty()) fail(GLISSADE_TEXT("a parenthesis is not closed"));
    if (c == ')' && valuesOfList_.empty()) fail(GLISSADE_TEXT("a parenthesis is closed that was not opened"));
    if (c == '(') valuesOfList_.push_back(1);
    if (c == ')' && !valuesOfList_.empty()) valuesOfList_.pop_back();
    if (c == ',' && !valuesOfList_.empty()) ++valuesOfList_.back();
    if (valuesOfList_.size() > kMostParentheses) {
      fail({GLISSADE_TEXT("parentheses are nested more than %1 deep"), {kMostParentheses}});
    }
    if (!isTessellation_ && !valuesOfList_.empty() && valuesOfList_.back() > kLongestList) {
      fail({GLISSADE_TEXT("a list has more than %1 values"), {kLongestList}});
    }
  }

  /// Checks a word among values, which is a typed value with parentheses.
  void checkWord() {
    const std::size_t end = endOf(isOfWord, at_);
    const std::size_t next = endOf(isSpace, end);
    const bool alone = next < text_.size() && (text_[next] == ',' || text_[next] == ')');
    if (alone && !valuesOfList_.empty()) fail({GLISSADE_TEXT("'%1' is not a value"), {shown(end)}});
    at_ = end;
  }

  void checkNumber() {
    const std::size_t end = endOf(isOfNumber, at_);
    if (end - at_ > kLongestNumber) {
      fail({GLISSADE_TEXT("a number has %1 characters"), {end - at_}});
    } else if (!isFinite(text_.substr(at_, end - at_)) || isGluedTo(end)) {
      fail({GLISSADE_TEXT("'%1' is not a finite number"), {shown(endOf(isOfWord, end))}});
    }
    at_ = end;
  }

  bool isDigitAt(std::size_t at) const { return at < text_.size() && isDigit(text_[at]); }

  /// True for a token such as 1.#INF, which some C libraries print.
  bool isGluedTo(std::size_t end) const { return end < text_.size() && (isLetter(text_[end]) || text_[end] == '#'); }

  template <class Predicate>
  std::size_t endOf(const Predicate& belongs, std::size_t from) const {
    while (from < text_.size() && belongs(text_[from])) ++from;
    return from;
  }

  /// A token without an end is left to the parser, which refuses it.
  void skipTo(std::size_t end, std::size_t length) {
    at_ = end == std::string_view::npos ? text_.size() : end + length;
  }

  /// The beginning of a token, for a message.
  std::string shown(std::size_t end) const {
    constexpr std::size_t kMost = 24;
    std::string token(text_.substr(at_, std::min(end - at_, kMost)));
    std::replace_if(
        token.begin(), token.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return token;
  }

  void fail(const Message& reason) { failAt(at_, reason); }
  void failAt(std::size_t at, const Message& reason) {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    fault_ = Message(GLISSADE_TEXT("line %1: %2"), {line, reason});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::size_t> valuesOfList_;  ///< number of values of each open list
  bool isTessellation_ = false;            ///< the entity's lists are not given to OpenCASCADE
  StepReferences references_;
  std::optional<Message> fault_;
};

}  // namespace

std::optional<Message> faultOfStepText(std::string_view text) { return StepTextCheck(text).fault(); }

}  // namespace glissade
