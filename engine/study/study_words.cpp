#include "engine/study/study_words.h"

#include "engine/study/study_french.h"

namespace glissade {

std::optional<Language> languageOf(std::string_view code) {
  if (code == "en") return Language::English;
  if (code == "fr") return Language::French;
  return std::nullopt;
}

const char* code(Language language) { return language == Language::French ? "fr" : "en"; }

bool StudyWords::knows(std::string_view english) const {
  return language_ == Language::English || studyFrench().count(english) != 0;
}

std::string StudyWords::operator()(std::string_view english, std::initializer_list<std::string> arguments) const {
  std::string_view sentence = english;
  if (language_ == Language::French) {
    const auto found = studyFrench().find(english);
    if (found != studyFrench().end()) sentence = found->second;
  }
  std::string text;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool place =
        sentence[i] == '%' && i + 1 < sentence.size() && sentence[i + 1] >= '1' && sentence[i + 1] <= '9';
    const auto which = place ? static_cast<std::size_t>(sentence[i + 1] - '1') : arguments.size();
    if (which < arguments.size()) {
      text += *(arguments.begin() + which);
      ++i;
    } else {
      text += sentence[i];
    }
  }
  return text;
}

}  // namespace glissade
