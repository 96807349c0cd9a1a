#pragma once

#include <initializer_list>
#include <string>

#include "engine/base/message.h"

namespace glissade {

/// Texts of reports and instructions in a language. Numbers have the same form in every language, so that they can
/// be found in the tables.
class DocumentWords {
 public:
  DocumentWords(Language language = Language::English) : language_(language) {}

  Language language() const { return language_; }
  std::string operator()(CatalogueText text, std::initializer_list<MessageArgument> arguments = {}) const;
  /// A text that is not marked where it is used: the name of a state or a measure, a sentence of a study. A text that
  /// the catalogue has not, such as a sentence of a user's study, is unchanged.
  std::string operator()(const std::string& text) const;
  std::string operator()(const char*) const = delete;

 private:
  Language language_;
};

}  // namespace glissade
