#pragma once

#include <QDoubleSpinBox>

#include <optional>

namespace glissade {

/// A length (at first in millimetres) or an angle in degrees, which people may type in any unit: 25.4 mm, 1 in, 0.1
/// rad. A number without a unit is in the unit that is shown. It keeps more digits than it shows. A text that cannot be
/// read changes nothing and is announced.
class QuantityBox final : public QDoubleSpinBox {
  Q_OBJECT

 public:
  enum class Quantity { Length, Angle };

  QuantityBox(Quantity quantity, QWidget* parent);

  /// Sets the unit that is shown, in metres or radians, and its number of decimals. The value has to be set again
  /// afterwards.
  void setUnit(double unit, int decimals);

  double valueFromText(const QString& text) const override;
  QString textFromValue(double value) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;
  /// Ctrl+Z undoes the last edit of the document, not letters in the field.
  bool event(QEvent* event) override;

 signals:
  /// The text is no number of this quantity, or one outside of the range; the value stays.
  void refused(const QString& text) const;

 private:
  std::optional<double> quantityOf(const QString& text) const;
  QString bare(const QString& text) const;

  Quantity quantity_;
  double unit_;
  int decimals_;
};

}  // namespace glissade
