#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "engine/base/message.h"

namespace glissade {

/// Texts of reports, plots and findings in a language. English sentences are the keys, with %1 to %9 for arguments. A
/// text without a translation, such as a sentence of a user's study, is unchanged. Numbers have the same form in every
/// language, so that they can be found in the tables.
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
