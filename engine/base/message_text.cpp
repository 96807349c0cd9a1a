#include <algorithm>

#include "engine/base/depth_text.h"
#include "engine/base/french_texts.h"
#include "engine/base/message.h"
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

}  // namespace

bool hasFrench(std::string_view english) { return findFrench(english) != frenchTexts().end(); }

std::string toString(const Message& message, const MessageStyle& style) {
  const std::string_view text =
      style.language == Language::English ? std::string_view(message.text) : inFrench(message.text);
  std::string filled;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t argument = isPlaceholder(text, i) ? static_cast<std::size_t>(text[i + 1] - '1') : 9;
    if (argument < message.arguments.size()) {
      filled += toString(message.arguments[argument], style);
      ++i;
    } else {
      filled += text[i];
    }
  }
  return filled;
}

}  // namespace glissade
