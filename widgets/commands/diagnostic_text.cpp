#include "widgets/commands/diagnostic_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "widgets/commands/diagnostic_sentences.h"

namespace glissade {
namespace {

/// The sentence as a pattern: what %1 and %2 stand for is captured.
QRegularExpression patternOf(const char* sentence) {
  QString pattern = QRegularExpression::escape(QString::fromUtf8(sentence));
  pattern.replace(QRegularExpression(QStringLiteral("\\\\%[1-9]")), QStringLiteral("(.+)"));
  return QRegularExpression(QStringLiteral("^%1$").arg(pattern));
}

QString asSentence(QString text) {
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith(QLatin1Char('.'))) text += QLatin1Char('.');
  return text;
}

}  // namespace

QString engineText(const std::string& text) {
  const QString given = QString::fromStdString(text);
  for (const char* sentence : kDiagnosticSentences) {
    const QRegularExpressionMatch match = patternOf(sentence).match(given);
    if (!match.hasMatch()) continue;
    QString translated = QCoreApplication::translate("Diagnostics", sentence);
    for (int i = 1; i <= match.lastCapturedIndex(); ++i) {
      translated.replace(QStringLiteral("%%1").arg(i), match.captured(i));
    }
    return translated;
  }
  return given;
}

QString diagnosticText(const Diagnostic& why) {
  const QString reason = asSentence(engineText(why.reason));
  const QString advice = asSentence(engineText(why.advice));
  return advice.isEmpty() ? reason : reason + QLatin1Char(' ') + advice;
}

QString diagnosticLine(const Diagnostic& why) {
  Diagnostic translated = why;
  translated.reason = engineText(why.reason).toStdString();
  translated.advice = engineText(why.advice).toStdString();
  return QString::fromStdString(toString(translated));
}

}  // namespace glissade
