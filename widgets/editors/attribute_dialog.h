#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLineEdit>

#include "engine/environment/attribute.h"

namespace glissade {

/// Asks what an attribute of the user's is to be.
class AttributeDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit AttributeDialog(AttributeOwner owner, QWidget* parent = nullptr);

  AttributeDefinition definition() const;

 private:
  QLineEdit* name_;
  QComboBox* type_;
  QComboBox* owner_;
  QLineEdit* unit_;
  QLineEdit* choices_;
  QLineEdit* description_;
};

}  // namespace glissade
