#include "widgets/commands/diagnostic_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace glissade {
namespace {

/// Sentences of the engine that people meet in the window; %1 and %2 stand for what differs.
// NOLINTBEGIN(bugprone-suspicious-missing-comma): a long text is several literals.
constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("Diagnostics", "the object penetrates '%1'"),
    QT_TRANSLATE_NOOP("Diagnostics", "the object is %1 m from '%2', nearer than the required clearance of %3 m"),
    QT_TRANSLATE_NOOP("Diagnostics", "Move the start to a free place."),
    QT_TRANSLATE_NOOP("Diagnostics", "Move the goal to a free place."),
    QT_TRANSLATE_NOOP("Diagnostics", "Move the start away or lower the required clearance."),
    QT_TRANSLATE_NOOP("Diagnostics", "Move the goal away or lower the required clearance."),
    QT_TRANSLATE_NOOP("Diagnostics", "lies outside the workspace bounds"),
    QT_TRANSLATE_NOOP("Diagnostics", "Enlarge the workspace or move the start inside."),
    QT_TRANSLATE_NOOP("Diagnostics", "Enlarge the workspace or move the goal inside."),
    QT_TRANSLATE_NOOP("Diagnostics",
                      "'out' cannot be reached: the workspace holds no place clear of the obstacles' box"),
    QT_TRANSLATE_NOOP("Diagnostics", "Enlarge the workspace by the size of the object on one side at least."),
    QT_TRANSLATE_NOOP("Diagnostics", "the step limit of %1 reached without a path"),
    QT_TRANSLATE_NOOP("Diagnostics", "the limit of %1 random configurations reached without a path"),
    QT_TRANSLATE_NOOP("Diagnostics", "the time limit of %1 s reached without a path"),
    QT_TRANSLATE_NOOP("Diagnostics", "Raise %1, take part with the device, or try another seed."),
    QT_TRANSLATE_NOOP("Diagnostics", "no direct motion is free"),
    QT_TRANSLATE_NOOP("Diagnostics", "Choose a planner that searches."),
    QT_TRANSLATE_NOOP("Diagnostics", "there is no configuration outside within the bounds"),
    QT_TRANSLATE_NOOP("Diagnostics", "strategy G found no path within its limit of samples"),
    QT_TRANSLATE_NOOP("Diagnostics", "there is no such planner"),
    QT_TRANSLATE_NOOP("Diagnostics", "it was stopped"),
    QT_TRANSLATE_NOOP("Diagnostics", "there is no path to export"),
    QT_TRANSLATE_NOOP("Diagnostics", "there is no path to report"),
    QT_TRANSLATE_NOOP("Diagnostics", "there is no path to film"),
    QT_TRANSLATE_NOOP("Diagnostics", "ffmpeg is needed for films, and is not installed"),
    QT_TRANSLATE_NOOP("Diagnostics",
                      "Install the package ffmpeg, or give a name that ends with .png for a series of pictures."),
    QT_TRANSLATE_NOOP("Diagnostics", "ffmpeg could not write the film: %1"),
    QT_TRANSLATE_NOOP("Diagnostics",
                      "Check the folder, its free space, and that ffmpeg has the codecs libx264 and libvpx-vp9."),
    QT_TRANSLATE_NOOP("Diagnostics", "films are not written in this format"),
    QT_TRANSLATE_NOOP("Diagnostics", "Choose one of: .mp4, .webm, .png."),
    QT_TRANSLATE_NOOP("Diagnostics", "Solve first."),
    QT_TRANSLATE_NOOP("Diagnostics", "there is no scenario that the path could be of"),
    QT_TRANSLATE_NOOP("Diagnostics", "Open its scenario first."),
    QT_TRANSLATE_NOOP("Diagnostics", "a path is being looked for"),
    QT_TRANSLATE_NOOP("Diagnostics", "Stop the run first."),
    QT_TRANSLATE_NOOP("Diagnostics", "a recording is shown"),
    QT_TRANSLATE_NOOP("Diagnostics", "Close the replay first."),
    QT_TRANSLATE_NOOP("Diagnostics", "cannot be read"),
    QT_TRANSLATE_NOOP("Diagnostics", "cannot be written"),
    QT_TRANSLATE_NOOP("Diagnostics", "does not exist"),
    QT_TRANSLATE_NOOP("Diagnostics", "Correct the file."),
    QT_TRANSLATE_NOOP("Diagnostics",
                      "is missing, and is free space to every proof: its file '%1' is not there (looked for in '%2')"),
    QT_TRANSLATE_NOOP(
        "Diagnostics",
        "is missing, and is free space to every proof: its file '%1' is outside its folder (looked for in '%2')"),
    QT_TRANSLATE_NOOP(
        "Diagnostics",
        "is missing, and is free space to every proof: its file '%1' is no STEP file (looked for in '%2')"),
    QT_TRANSLATE_NOOP("Diagnostics", "%1 more files of its parts are missing"),
    QT_TRANSLATE_NOOP("Diagnostics",
                      "has its parts in other files, and none of them is there: %1 (looked for in '%2')"),
    QT_TRANSLATE_NOOP("Diagnostics", "Put the files there and load again, or export the product as one file."),
    QT_TRANSLATE_NOOP("Diagnostics", "names '%1' for a part, which holds this file itself"),
    QT_TRANSLATE_NOOP("Diagnostics", "Export the product as one file."),
    QT_TRANSLATE_NOOP("Diagnostics", "had %1 planar holes, which were closed as asked for; %2 holes are left open"),
    QT_TRANSLATE_NOOP("Diagnostics", "Look at them: what is behind a closed hole is solid."),
    QT_TRANSLATE_NOOP("Diagnostics", "is not a closed surface"),
    QT_TRANSLATE_NOOP("Diagnostics",
                      "Being inside it is not seen as a collision; close its surface, or let planar holes be closed "
                      "(--close-holes)."),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

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
  for (const char* sentence : kSentences) {
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

}  // namespace glissade
