#include "widgets/controls/diagnostic_text.h"

#include "widgets/controls/length_text.h"
#include "widgets/controls/window_language.h"

namespace glissade {
namespace {

QString asSentence(QString text) {
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith(QLatin1Char('.'))) text += QLatin1Char('.');
  return text;
}

}  // namespace

MessageStyle windowStyle() {
  MessageStyle style(windowLanguage());
  style.length = [](double metres) { return lengthText(metres).toStdString(); };
  return style;
}

QString engineText(const Message& message) { return QString::fromStdString(toString(message, windowStyle())); }

QString diagnosticText(const Diagnostic& why) {
  const QString reason = asSentence(engineText(why.reason));
  const QString advice = asSentence(engineText(why.advice));
  return advice.isEmpty() ? reason : reason + QLatin1Char(' ') + advice;
}

QString diagnosticLine(const Diagnostic& why) { return QString::fromStdString(toString(why, windowStyle())); }

}  // namespace glissade
