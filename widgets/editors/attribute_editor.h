#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "engine/environment/attribute.h"

namespace glissade {

/// The editor of one attribute's value, made for its type: check box, spin box with unit, combo box
/// or line of text. Several owners with different values show as "—" until one is chosen.
class AttributeEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit AttributeEditor(const AttributeDefinition& definition, QWidget* parent = nullptr);

  /// Nothing: the owners differ. Does not emit.
  void setValue(const std::optional<AttributeValue>& value);

 signals:
  void edited(const glissade::AttributeValue& value);

 private:
  QWidget* makeCheckBox();
  QWidget* makeSpinBox(const AttributeDefinition& definition);
  QWidget* makeNumberBox(const AttributeDefinition& definition);
  QWidget* makeComboBox(const AttributeDefinition& definition);
  QWidget* makeLine();

  std::function<void(const std::optional<AttributeValue>&)> show_;
};

}  // namespace glissade
