#include "engine/base/message.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

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

namespace {

/// The messages with a separator between them. There are at most nine, because a text has no more arguments.
Message joinedInOneText(std::vector<MessageArgument> messages, std::string_view separator) {
  std::string text;
  for (std::size_t i = 1; i <= messages.size(); ++i) {
    text += (i > 1 ? std::string(separator) : "") + "%" + std::to_string(i);
  }
  return {CatalogueText{text.c_str()}, std::move(messages)};
}

}  // namespace

/// Joins nine at a time, so that a long list is nested a few levels deep.
Message joined(const std::vector<Message>& messages, std::string_view separator) {
  if (messages.empty()) return {};
  constexpr std::size_t kMost = 9;
  std::vector<Message> left = messages;
  while (left.size() > 1) {
    std::vector<Message> joint;
    for (std::size_t first = 0; first < left.size(); first += kMost) {
      const std::size_t end = std::min(first + kMost, left.size());
      std::vector<MessageArgument> some(std::make_move_iterator(left.begin() + static_cast<std::ptrdiff_t>(first)),
                                        std::make_move_iterator(left.begin() + static_cast<std::ptrdiff_t>(end)));
      joint.push_back(some.size() == 1 ? std::move(std::get<Message>(some.front().value))
                                       : joinedInOneText(std::move(some), separator));
    }
    left = std::move(joint);
  }
  return left.front();
}

}  // namespace glissade
