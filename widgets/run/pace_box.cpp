#include "widgets/run/pace_box.h"

#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <array>

#include "engine/base/parameters.h"

namespace glissade {
namespace {

constexpr double kPaperPace = 40.0;
constexpr std::array<double, 6> kPaces{0.0, 1000.0, 200.0, kPaperPace, 10.0, 1.0};

QString paceText(double pace) {
  if (pace <= 0.0) return PaceBox::tr("Full speed");
  const QString number = QLocale().toString(pace, 'g', 6);
  if (pace == kPaperPace) return PaceBox::tr("%1 steps a second: real time").arg(number);
  return PaceBox::tr("%1 steps a second").arg(number);
}

}  // namespace

PaceBox::PaceBox(QWidget* parent) : QComboBox(parent) {
  setEditable(true);
  setInsertPolicy(QComboBox::NoInsert);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(12);
  setAccessibleName(tr("Pace"));
  setToolTip(tr("How fast a run goes: choose a pace or type steps a second, to watch and to steer"));
  for (const double pace : kPaces) addItem(paceText(pace), pace);
  connect(this, QOverload<int>::of(&QComboBox::activated), this, [this] { takeText(currentText()); });
  connect(lineEdit(), &QLineEdit::editingFinished, this, [this] { takeText(lineEdit()->text()); });
}

void PaceBox::setPace(double stepsPerSecond) {
  pace_ = stepsPerSecond;
  if (lineEdit()->hasFocus()) return;
  const QSignalBlocker block(this);
  setCurrentIndex(findData(pace_));
  setEditText(paceText(pace_));
  lineEdit()->setCursorPosition(0);
}

void PaceBox::takeText(const QString& text) {
  double pace = pace_;
  if (text == paceText(0.0)) {
    pace = 0.0;
  } else {
    const QString number = text.section(QRegularExpression(QStringLiteral("[^0-9.,]")), 0, 0);
    bool ok = false;
    const double typed = QLocale().toDouble(number, &ok);
    const ParameterRange range = rangeOf(ParameterId::Pace, 1.0);
    if (ok && typed >= range.minimum && typed <= range.maximum) pace = typed;
  }
  const bool changed = pace != pace_;
  pace_ = pace;
  setEditText(paceText(pace_));
  lineEdit()->setCursorPosition(0);
  if (changed) emit paceChosen(pace_);
}

}  // namespace glissade
