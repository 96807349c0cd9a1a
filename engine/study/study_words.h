#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace glissade {

enum class Language { English, French };
/// "en" or "fr".
std::optional<Language> languageOf(std::string_view code);
const char* code(Language language);

/// What reports, plots and findings say, in a language. English sentences are the keys, with %1 to %9
/// where arguments belong; what has no translation, as the sentences of one's own studies, stays as it
/// is. Numbers look the same in every language: they can be found again in the tables.
class StudyWords {
 public:
  StudyWords(Language language = Language::English) : language_(language) {}

  Language language() const { return language_; }
  std::string operator()(std::string_view english, std::initializer_list<std::string> arguments = {}) const;
  bool knows(std::string_view english) const;

 private:
  Language language_;
};

}  // namespace glissade
