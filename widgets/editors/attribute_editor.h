#pragma once

#include <QAbstractSpinBox>
#include <QWidget>

#include <functional>
#include <optional>

#include "engine/environment/attribute.h"

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

/// The editor of one attribute's value, made for its type: check box, spin box with unit, combo box
/// or line of text. Several owners with different values show as "—" until one is chosen. The wheel only
/// turns an editor that has the focus, and undoing is left to the window.
class AttributeEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit AttributeEditor(const AttributeDefinition& definition, QWidget* parent = nullptr);

  /// Nothing: the owners differ. Does not emit.
  void setValue(const std::optional<AttributeValue>& value);

 signals:
  void edited(const glissade::AttributeValue& value);
  void finished();  ///< what is edited from now on is another edit

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeCheckBox();
  QWidget* makeSpinBox(const AttributeDefinition& definition);
  QWidget* makeNumberBox(const AttributeDefinition& definition);
  template <class Box, class Number>
  QWidget* connected(RangeBox<Box, Number>* box, const std::string& unit, double scale = 1.0);
  QWidget* makeComboBox(const AttributeDefinition& definition);
  QWidget* makeLine();

  std::function<void(const std::optional<AttributeValue>&)> show_;
};

}  // namespace glissade
