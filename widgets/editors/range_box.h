#pragma once

#include <QAbstractSpinBox>

namespace glissade {

/// A spin box (`Box`: QSpinBox or QDoubleSpinBox) whose minimum lies one step below its least value and is shown as its
/// special text: neither steps nor typing lead there.
template <class Box, class Number>
class RangeBox final : public Box {
 public:
  RangeBox(Number least, QWidget* parent) : Box(parent), least_(least) {}

  bool isInRange() const { return this->value() >= least_; }
  void stepBy(int steps) override {
    if (isInRange() && this->value() + steps * this->singleStep() >= least_) {
      Box::stepBy(steps);
    } else if (isInRange() || steps > 0) {
      this->setValue(least_);
    }
  }

 protected:
  QAbstractSpinBox::StepEnabled stepEnabled() const override {
    const auto enabled = Box::stepEnabled();
    return this->value() > least_ ? enabled
                                  : enabled & ~QAbstractSpinBox::StepEnabled(QAbstractSpinBox::StepDownEnabled);
  }
  QValidator::State validate(QString& text, int& position) const override {
    const QValidator::State state = Box::validate(text, position);
    const bool number = state == QValidator::Acceptable && text != this->specialValueText();
    return number && this->valueFromText(text) < least_ ? QValidator::Intermediate : state;
  }

 private:
  Number least_;
};

}  // namespace glissade
