#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/depth_text.h"
#include "engine/base/french_texts.h"
#include "engine/base/message.h"
#include "engine/base/number_text.h"
#include "engine/base/overloaded.h"
#include "engine/base/quantity_text.h"

namespace glissade {
namespace {

std::string toString(const MessageArgument& argument, const MessageStyle& style) {
  return std::visit(Overloaded{[](const std::string& text) { return text; },
                               [&](const Length& length) {
                                 return style.length ? style.length(length.metres) : inMillimetres(length.metres);
                               },
                               [](const Depth& depth) { return depthInMillimetres(depth.metres); },
                               [&](const Message& message) { return glissade::toString(message, style); }},
                    argument.value);
}

/// The position of the English text in the catalogue; the end where it is not there.
auto findFrench(std::string_view english) {
  const auto texts = frenchTexts();
  const auto found = std::lower_bound(texts.begin(), texts.end(), english,
                                      [](const FrenchText& text, std::string_view of) { return text.english < of; });
  return found != texts.end() && found->english == english ? found : texts.end();
}

/// The English text where there is no French one.
std::string_view inFrench(std::string_view english) {
  const auto found = findFrench(english);
  return found == frenchTexts().end() ? english : found->french;
}

bool isPlaceholder(std::string_view text, std::size_t at) {
  return text[at] == '%' && at + 1 < text.size() && text[at + 1] >= '1' && text[at + 1] <= '9';
}

/// True if a noun with this number is singular. English: one; French: less than two.
bool isSingular(std::string_view number, Language language) {
  if (language == Language::English) return number == "1";
  std::string decimal(number);
  std::replace(decimal.begin(), decimal.end(), ',', '.');
  const auto value = toNumber(decimal);
  return value && std::abs(*value) < 2.0;
}

/// The two forms of a word at a place of a text: "{1|part|parts}", the first one where argument 1 is singular.
struct NumberForms {
  std::size_t argument;
  std::string_view singular;
  std::string_view plural;
  std::size_t length;  ///< of the whole, with its braces
};

std::optional<NumberForms> formsAt(std::string_view text) {
  const std::size_t end = text.find('}');
  if (end == std::string_view::npos || end < 4 || text[0] != '{' || text[1] < '1' || text[1] > '9' || text[2] != '|') {
    return std::nullopt;
  }
  const std::string_view forms = text.substr(3, end - 3);
  const std::size_t bar = forms.find('|');
  if (bar == std::string_view::npos) return std::nullopt;
  return NumberForms{static_cast<std::size_t>(text[1] - '1'), forms.substr(0, bar), forms.substr(bar + 1), end + 1};
}

}  // namespace

bool hasFrench(std::string_view english) { return findFrench(english) != frenchTexts().end(); }

std::string toString(const Message& message, const MessageStyle& style) {
  const std::string_view text =
      style.language == Language::English ? std::string_view(message.text) : inFrench(message.text);
  std::string filled;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t argument = isPlaceholder(text, i) ? static_cast<std::size_t>(text[i + 1] - '1') : 9;
    const auto forms = formsAt(text.substr(i));
    if (argument < message.arguments.size()) {
      filled += toString(message.arguments[argument], style);
      ++i;
    } else if (forms && forms->argument < message.arguments.size()) {
      const std::string number = toString(message.arguments[forms->argument], style);
      filled += isSingular(number, style.language) ? forms->singular : forms->plural;
      i += forms->length - 1;
    } else {
      filled += text[i];
    }
  }
  return filled;
}

}  // namespace glissade
