#include "engine/base/message.h"

namespace glissade {

std::optional<Language> languageOf(std::string_view code) {
  if (code == "en") return Language::English;
  if (code == "fr") return Language::French;
  return std::nullopt;
}

const char* code(Language language) { return language == Language::French ? "fr" : "en"; }

Message::Message(CatalogueText english, std::initializer_list<MessageArgument> list)
    : text(english.english), arguments(list) {}
Message::Message(CatalogueText english, std::vector<MessageArgument> list)
    : text(english.english), arguments(std::move(list)) {}
Message::Message(std::string plain) {
  if (!plain.empty()) *this = Message(CatalogueText{"%1"}, {std::move(plain)});
}
Message::Message(const char* plain) : Message(std::string(plain)) {}

bool Message::operator==(const Message& other) const { return text == other.text && arguments == other.arguments; }

Message joined(const std::vector<Message>& messages, std::string_view separator) {
  if (messages.empty()) return {};
  Message all = messages.front();
  for (std::size_t i = 1; i < messages.size(); ++i) {
    const std::string pattern = "%1" + std::string(separator) + "%2";
    all = Message(CatalogueText{pattern.c_str()}, {std::move(all), messages[i]});
  }
  return all;
}

}  // namespace glissade
