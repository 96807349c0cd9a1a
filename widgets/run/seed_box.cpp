#include "widgets/run/seed_box.h"

#include <QLineEdit>

#include <algorithm>
#include <limits>

namespace glissade {
namespace {

constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();

}  // namespace

SeedBox::SeedBox(QWidget* parent) : QAbstractSpinBox(parent) {
  setSeed(0);
  connect(lineEdit(), &QLineEdit::textEdited, this, [this](const QString& text) {
    bool ok = false;
    const quint64 seed = text.trimmed().toULongLong(&ok);
    if (ok) choose(seed);
  });
  connect(this, &QAbstractSpinBox::editingFinished, this, [this] { setSeed(seed_); });
}

void SeedBox::setSeed(std::uint64_t seed) {
  seed_ = seed;
  lineEdit()->setText(QString::number(static_cast<qulonglong>(seed)));
}

void SeedBox::choose(std::uint64_t seed) {
  if (seed == seed_) return;
  seed_ = seed;
  emit seedChosen(seed);
}

void SeedBox::stepBy(int steps) {
  const auto by = static_cast<std::uint64_t>(steps < 0 ? -static_cast<std::int64_t>(steps) : steps);
  const std::uint64_t last = seed_;
  if (steps < 0) {
    choose(last - std::min(last, by));
  } else {
    choose(last + std::min(kLargest - last, by));
  }
  setSeed(seed_);
}

QAbstractSpinBox::StepEnabled SeedBox::stepEnabled() const {
  StepEnabled enabled = StepNone;
  if (seed_ > 0) enabled |= StepDownEnabled;
  if (seed_ < kLargest) enabled |= StepUpEnabled;
  return enabled;
}

QValidator::State SeedBox::validate(QString& input, int& /*position*/) const {
  const QString digits = input.trimmed();
  if (digits.isEmpty()) return QValidator::Intermediate;
  bool ok = false;
  (void)digits.toULongLong(&ok);
  return ok && digits[0].isDigit() ? QValidator::Acceptable : QValidator::Invalid;
}

void SeedBox::fixup(QString& input) const { input = QString::number(static_cast<qulonglong>(seed_)); }

}  // namespace glissade
