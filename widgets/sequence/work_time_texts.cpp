#include "widgets/sequence/work_time_texts.h"

#include <QCoreApplication>
#include <QLocale>

#include "widgets/controls/diagnostic_text.h"

namespace glissade {
namespace {

QString say(const char* text) { return QCoreApplication::translate("WorkTimes", text); }

QLocale numbers(const QLocale& language) {
  QLocale locale(language);
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  return locale;
}

}  // namespace

QString workTimeName(const WorkTimeRow& row) {
  QString name = engineText(row.meaning);
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
