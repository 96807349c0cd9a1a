#include "widgets/editors/attribute_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace glissade {

AttributeDialog::AttributeDialog(AttributeOwner owner, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(this)),
      type_(new QComboBox(this)),
      owner_(new QComboBox(this)),
      unit_(new QLineEdit(this)),
      choices_(new QLineEdit(this)),
      description_(new QLineEdit(this)) {
  setWindowTitle(tr("Add an attribute"));
  type_->addItem(tr("yes or no"), static_cast<int>(AttributeType::Bool));
  type_->addItem(tr("whole number"), static_cast<int>(AttributeType::Integer));
  type_->addItem(tr("number"), static_cast<int>(AttributeType::Number));
  type_->addItem(tr("text"), static_cast<int>(AttributeType::Text));
  type_->addItem(tr("choice"), static_cast<int>(AttributeType::Choice));
  owner_->addItem(tr("places"), static_cast<int>(AttributeOwner::Place));
  owner_->addItem(tr("bodies"), static_cast<int>(AttributeOwner::Body));
  owner_->setCurrentIndex(owner == AttributeOwner::Place ? 0 : 1);
  name_->setPlaceholderText(tr("lower-case letters, digits and _"));
  choices_->setPlaceholderText(tr("separated by commas"));
  auto* form = new QFormLayout;
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Type"), type_);
  form->addRow(tr("Describes"), owner_);
  form->addRow(tr("Unit"), unit_);
  form->addRow(tr("Choices"), choices_);
  form->addRow(tr("Meaning"), description_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(buttons);
  const auto enable = [this, buttons] {
    const auto type = static_cast<AttributeType>(type_->currentData().toInt());
    unit_->setEnabled(type == AttributeType::Integer || type == AttributeType::Number);
    choices_->setEnabled(type == AttributeType::Choice);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(!name_->text().trimmed().isEmpty());
  };
  connect(name_, &QLineEdit::textChanged, this, enable);
  connect(type_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, enable);
  enable();
}

AttributeDefinition AttributeDialog::definition() const {
  AttributeDefinition definition;
  definition.name = definition.label = name_->text().trimmed().toStdString();
  definition.type = static_cast<AttributeType>(type_->currentData().toInt());
  definition.owner = static_cast<AttributeOwner>(owner_->currentData().toInt());
  if (unit_->isEnabled()) definition.unit = unit_->text().trimmed().toStdString();
  if (choices_->isEnabled()) {
    for (const QString& choice : choices_->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
      definition.choices.push_back(choice.trimmed().toStdString());
    }
  }
  definition.description = description_->text().trimmed().toStdString();
  definition.initial = initialValue(definition);
  return definition;
}

}  // namespace glissade
