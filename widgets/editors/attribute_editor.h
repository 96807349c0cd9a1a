#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "engine/environment/attribute.h"
#include "widgets/editors/range_box.h"

namespace glissade {

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
