#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/number_text.h"

namespace glissade {

enum class Language { English, French };
/// The language of the code "en" or "fr".
std::optional<Language> languageOf(std::string_view code);
const char* code(Language language);

/// An English text of the catalogue `resources/i18n`, with %1 to %9 where arguments are. "{1|part|parts}" is the first
/// form where argument 1 is a singular number in the reader's language. GLISSADE_TEXT makes the text, so that lupdate
/// finds every text.
struct CatalogueText {
  const char* english;
};
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): lupdate knows the texts by the name of the macro.
#define GLISSADE_TEXT(english) \
  ::glissade::CatalogueText { english }

/// A length that is shown with three significant digits.
struct Length {
  double metres;
  bool operator==(const Length& other) const { return metres == other.metres; }
};

/// The depth of an overlap, which is shown in whole micrometres, because a person accepts it as stated.
struct Depth {
  double metres;
  bool operator==(const Depth& other) const { return metres == other.metres; }
};

struct MessageArgument;

/// A text for people as data: a text of the catalogue and its arguments. The reader chooses the language.
struct Message {
  Message() = default;
  Message(CatalogueText text, std::initializer_list<MessageArgument> arguments = {});
  Message(CatalogueText text, std::vector<MessageArgument> arguments);
  /// A text that is equal in all languages: a name, a place in a file, the text of a library.
  explicit Message(std::string text);
  explicit Message(const char* text);

  bool empty() const { return text.empty(); }
  bool operator==(const Message& other) const;

  std::string text;
  std::vector<MessageArgument> arguments;
};

/// The value that replaces one of %1 to %9: a text, a length, a depth or a message.
struct MessageArgument {
  MessageArgument(std::string text) : value(std::move(text)) {}
  MessageArgument(std::string_view text) : value(std::string(text)) {}
  MessageArgument(const char* text) : value(std::string(text)) {}
  template <class Number, std::enable_if_t<std::is_integral_v<Number>, int> = 0>
  MessageArgument(Number number) : value(std::to_string(number)) {}
  MessageArgument(double number) : value(toText(number)) {}
  MessageArgument(Length length) : value(length) {}
  MessageArgument(Depth depth) : value(depth) {}
  MessageArgument(CatalogueText text) : value(Message(text)) {}
  MessageArgument(Message message) : value(std::move(message)) {}

  bool operator==(const MessageArgument& other) const { return value == other.value; }

  std::variant<std::string, Length, Depth, Message> value;
};

/// Language and units of a reader.
struct MessageStyle {
  MessageStyle(Language language = Language::English) : language(language) {}

  Language language;
  std::function<std::string(double metres)> length;  ///< empty: millimetres with three significant digits
};

/// The text for a reader. A text that the catalogue has not is English in every language.
std::string toString(const Message& message, const MessageStyle& style = {});

/// True if the catalogue has a French text for the English one.
bool hasFrench(std::string_view english);

/// The messages with a separator between them; `separator` is equal in all languages.
Message joined(const std::vector<Message>& messages, std::string_view separator);

}  // namespace glissade
