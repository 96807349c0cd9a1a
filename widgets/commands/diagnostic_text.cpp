#include "widgets/commands/diagnostic_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <vector>

#include "widgets/commands/base_sentences.h"
#include "widgets/commands/check_sentences.h"
#include "widgets/commands/diagnostic_sentences.h"
#include "widgets/commands/import_sentences.h"
#include "widgets/commands/joint_sentences.h"
#include "widgets/commands/planning_sentences.h"
#include "widgets/commands/scenario_sentences.h"
#include "widgets/commands/window_language.h"

namespace glissade {
namespace {

const QRegularExpression& placeholder() {
  static const QRegularExpression pattern(QStringLiteral("%[1-9]"));
  return pattern;
}

/// A sentence of the engine, and the pattern of its texts, which captures the parts for %1 and %2.
struct Sentence {
  const char* english;
  QRegularExpression pattern;
  int letters;  ///< without the placeholders
};

Sentence sentenceOf(const char* english) {
  const QString text = QString::fromUtf8(english);
  QString pattern = QRegularExpression::escape(text);
  pattern.replace(QRegularExpression(QStringLiteral("\\\\%[1-9]")), QStringLiteral("(.*?)"));
  return {english,
          QRegularExpression(QStringLiteral("^%1$").arg(pattern), QRegularExpression::DotMatchesEverythingOption),
          QString(text).remove(placeholder()).size()};
}

/// All sentences. The longest ones come first, so that specific sentences are tried before general ones.
std::vector<Sentence> allSentences() {
  std::vector<Sentence> all;
  const auto take = [&all](const auto& texts) {
    for (const char* text : texts) all.push_back(sentenceOf(text));
  };
  take(kDiagnosticSentences);
  take(kBaseSentences);
  take(kCheckSentences);
  take(kImportSentences);
  take(kJointSentences);
  take(kPlanningSentences);
  take(kScenarioSentences);
  std::stable_sort(all.begin(), all.end(), [](const Sentence& a, const Sentence& b) { return a.letters > b.letters; });
  return all;
}

QString translated(const QString& text);

/// The sentence in the user's language. A captured part may be a sentence, too, unless it is in quotes: then it is a
/// name.
QString filled(const Sentence& sentence, const QRegularExpressionMatch& match) {
  const QString pattern = QCoreApplication::translate("Diagnostics", sentence.english);
  const QString english = QString::fromUtf8(sentence.english);
  QString result;
  int from = 0;
  for (auto places = placeholder().globalMatch(pattern); places.hasNext();) {
    const QRegularExpressionMatch place = places.next();
    result += pattern.mid(from, place.capturedStart() - from);
    const QString what = match.captured(place.captured().mid(1).toInt());
    const bool name = english.contains(QStringLiteral("'%1'").arg(place.captured()));
    result += name ? what : translated(what);
    from = place.capturedEnd();
  }
  return result + pattern.mid(from);
}

QString translated(const QString& text) {
  static const std::vector<Sentence> sentences = allSentences();
  if (text.isEmpty()) return text;
  for (const Sentence& sentence : sentences) {
    const QRegularExpressionMatch match = sentence.pattern.match(text);
    if (match.hasMatch()) return filled(sentence, match);
  }
  return text;
}

QString asSentence(QString text) {
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith(QLatin1Char('.'))) text += QLatin1Char('.');
  return text;
}

}  // namespace

QString engineText(const std::string& text) { return translated(QString::fromStdString(text)); }

QString engineText(const Message& message) {
  if (message.text == "%1") return engineText(toString(message));
  return QString::fromStdString(toString(message, windowLanguage()));
}

QString diagnosticText(const Diagnostic& why) {
  const QString reason = asSentence(engineText(why.reason));
  const QString advice = asSentence(engineText(why.advice));
  return advice.isEmpty() ? reason : reason + QLatin1Char(' ') + advice;
}

QString diagnosticLine(const Diagnostic& why) { return QString::fromStdString(toString(why, windowLanguage())); }

}  // namespace glissade
