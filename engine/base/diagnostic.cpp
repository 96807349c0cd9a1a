#include "engine/base/diagnostic.h"

#include "engine/base/printable_text.h"

namespace glissade {

int exitCode(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::NoPath: return 1;
    case ErrorKind::Usage: return 2;
    case ErrorKind::MalformedInput:
    case ErrorKind::Unwritable: return 3;
    case ErrorKind::InCollision: return 4;
    case ErrorKind::LimitReached: return 5;
    case ErrorKind::Interrupted: return 130;
    case ErrorKind::Internal: return 70;
  }
  return 70;
}

std::string toString(const Diagnostic& diagnostic, const MessageStyle& style) {
  const char* colon = style.language == Language::French ? "\u00a0: " : ": ";
  std::string text;
  for (const std::string& part : {diagnostic.file, toString(diagnostic.location, style)}) {
    if (!part.empty()) text += printableLine(part) + colon;
  }
  text += printableText(toString(diagnostic.reason, style));
  if (!diagnostic.advice.empty()) {
    if (!text.empty() && text.back() != '.') text += ".";
    text += " " + printableText(toString(diagnostic.advice, style));
  }
  return text;
}

}  // namespace glissade
