#include "engine/study/study_words.h"

namespace glissade {
std::string StudyWords::operator()(CatalogueText text, std::initializer_list<MessageArgument> arguments) const {
  return toString(Message(text, arguments), language_);
}

std::string StudyWords::operator()(const std::string& text) const {
  return toString(Message(CatalogueText{text.c_str()}), language_);
}

}  // namespace glissade
