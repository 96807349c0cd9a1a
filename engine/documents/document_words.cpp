#include "engine/documents/document_words.h"

namespace glissade {
std::string DocumentWords::operator()(CatalogueText text, std::initializer_list<MessageArgument> arguments) const {
  return toString(Message(text, arguments), language_);
}

std::string DocumentWords::operator()(const std::string& text) const {
  return toString(Message(CatalogueText{text.c_str()}), language_);
}

}  // namespace glissade
