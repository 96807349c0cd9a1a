#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <functional>

#include "engine/environment/attribute.h"

namespace glissade {

/// Asks what an attribute of the user's is to be, until it can be added or is given up.
class AttributeDialog final : public QDialog {
  Q_OBJECT

 public:
  using Add = std::function<Outcome(const AttributeDefinition& definition)>;
  AttributeDialog(AttributeOwner owner, Add add, QWidget* parent = nullptr);

  /// Stays open where what was given is refused, and says why.
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
