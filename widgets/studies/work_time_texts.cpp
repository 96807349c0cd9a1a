#include "widgets/studies/work_time_texts.h"

#include <QCoreApplication>
#include <QLocale>

namespace glissade {
namespace {

/// The meanings of workTimeRows(), listed for the translators.
[[maybe_unused]] constexpr const char* kMeanings[] = {
    QT_TRANSLATE_NOOP("WorkTimes", "a part is small below this length"),
    QT_TRANSLATE_NOOP("WorkTimes", "a part is large above this length"),
    QT_TRANSLATE_NOOP("WorkTimes", "a heavier part is handled as a large one"),
    QT_TRANSLATE_NOOP("WorkTimes", "a heavier part needs a lifting aid"),
    QT_TRANSLATE_NOOP("WorkTimes", "fetch a part"),
    QT_TRANSLATE_NOOP("WorkTimes", "fetch a small part"),
    QT_TRANSLATE_NOOP("WorkTimes", "fetch a large part with both hands"),
    QT_TRANSLATE_NOOP("WorkTimes", "fetch a part with a lifting aid"),
    QT_TRANSLATE_NOOP("WorkTimes", "place a part along a straight way"),
    QT_TRANSLATE_NOOP("WorkTimes", "place a part into a fit"),
    QT_TRANSLATE_NOOP("WorkTimes", "place a part along a way with turns"),
    QT_TRANSLATE_NOOP("WorkTimes", "press a part into its seat"),
    QT_TRANSLATE_NOOP("WorkTimes", "lay a flexible part on"),
    QT_TRANSLATE_NOOP("WorkTimes", "start a thread"),
    QT_TRANSLATE_NOOP("WorkTimes", "one turn with a powered tool"),
    QT_TRANSLATE_NOOP("WorkTimes", "one turn by hand or with an open wrench"),
    QT_TRANSLATE_NOOP("WorkTimes", "take another tool"),
    QT_TRANSLATE_NOOP("WorkTimes", "hold one body meanwhile"),
};

QString say(const char* text) { return QCoreApplication::translate("WorkTimes", text); }

QLocale numbers(const QLocale& language) {
  QLocale locale(language);
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  return locale;
}

}  // namespace

QString workTimeName(const WorkTimeRow& row) {
  QString name = say(row.meaning.english);
  name[0] = name[0].toUpper();
  return name;
}

QString workTimeUnit(const WorkTimeRow& row) { return QString::fromLatin1(row.id).section(QLatin1Char('_'), -1); }

QString workTimeHelp(const WorkTimeRow& row) {
  const QString unit = workTimeUnit(row);
  return say(QT_TRANSLATE_NOOP(
                 "WorkTimes",
                 "Default: %1 %3. It is an estimate of the size of the tables for manual assembly in "
                 "Boothroyd, Dewhurst and Knight, Product Design for Manufacture and Assembly (2011), and "
                 "was not measured. Values from 0 to %2 %3 are taken."))
      .arg(workTimeText(WorkTimes().*row.value), workTimeText(row.most), unit);
}

QString workTimeText(double value) { return numbers(QLocale()).toString(value, 'g', QLocale::FloatingPointShortest); }

std::optional<double> workTimeIn(const QString& text) {
  for (const QLocale& language : {QLocale(), QLocale::c()}) {
    bool isNumber = false;
    const double value = numbers(language).toDouble(text.trimmed(), &isNumber);
    if (isNumber) return value;
  }
  return std::nullopt;
}

}  // namespace glissade
