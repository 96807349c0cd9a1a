#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <functional>

#include "engine/places/attribute.h"

namespace glissade {

/// Asks for the definition of a new attribute, until it can be added or the person cancels.
class AttributeDialog final : public QDialog {
  Q_OBJECT

 public:
  using Add = std::function<Outcome(const AttributeDefinition& definition)>;
  AttributeDialog(AttributeOwner owner, Add add, QWidget* parent = nullptr);

  /// If the definition is refused, the dialog stays open and shows the reason.
  void accept() override;

 private:
  QLineEdit* addLine(const char* name, const QString& hint = {});
  AttributeType type() const;
  void enable();
  Result<AttributeDefinition> definition() const;

  Add add_;
  QLineEdit* name_;
  QComboBox* type_;
  QComboBox* owner_;
  QLineEdit* unit_;
  QLineEdit* minimum_;
  QLineEdit* maximum_;
  QLineEdit* initial_;
  QLineEdit* choices_;
  QLineEdit* description_;
  QLabel* refusal_;
};

}  // namespace glissade
