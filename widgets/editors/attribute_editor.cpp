#include "widgets/editors/attribute_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

const QString kDiffers = QStringLiteral("—");

double numberOf(const AttributeValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? *number : 0.0;
}

QString textOf(const AttributeValue& value) {
  const std::string* text = std::get_if<std::string>(&value);
  return text != nullptr ? QString::fromStdString(*text) : QString();
}

}  // namespace

AttributeEditor::AttributeEditor(const AttributeDefinition& definition, QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2, 1, 2, 1);
  QWidget* editor = nullptr;
  switch (definition.type) {
    case AttributeType::Bool: editor = makeCheckBox(); break;
    case AttributeType::Integer: editor = makeSpinBox(definition); break;
    case AttributeType::Number: editor = makeNumberBox(definition); break;
    case AttributeType::Choice: editor = makeComboBox(definition); break;
    case AttributeType::Text: editor = makeLine(); break;
  }
  editor->setObjectName(QString::fromStdString("attribute-" + definition.name));
  editor->setToolTip(QString::fromStdString(definition.description));
  setFocusProxy(editor);
  layout->addWidget(editor);
}

void AttributeEditor::setValue(const std::optional<AttributeValue>& value) { show_(value); }

QWidget* AttributeEditor::makeCheckBox() {
  auto* box = new QCheckBox(this);
  connect(box, &QCheckBox::clicked, this, [this, box] {
    box->setTristate(false);
    emit edited(AttributeValue(box->isChecked()));
  });
  show_ = [box](const std::optional<AttributeValue>& value) {
    const QSignalBlocker block(box);
    box->setTristate(!value);
    const bool* flag = value ? std::get_if<bool>(&*value) : nullptr;
    box->setText(!value ? kDiffers : flag != nullptr && *flag ? tr("yes") : tr("no"));
    box->setCheckState(!value ? Qt::PartiallyChecked : flag != nullptr && *flag ? Qt::Checked : Qt::Unchecked);
  };
  return box;
}

/// One below the range stands for "different".
QWidget* AttributeEditor::makeSpinBox(const AttributeDefinition& definition) {
  auto* box = new QSpinBox(this);
  const int least = static_cast<int>(std::max(definition.minimum, -1e9));
  box->setRange(least - 1, static_cast<int>(std::min(definition.maximum, 1e9)));
  box->setSpecialValueText(kDiffers);
  box->setSuffix(definition.unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(definition.unit));
  connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, [this, least](int value) {
    if (value >= least) emit edited(AttributeValue(static_cast<double>(value)));
  });
  show_ = [box, least](const std::optional<AttributeValue>& value) {
    const QSignalBlocker block(box);
    box->setValue(value ? static_cast<int>(std::lround(numberOf(*value))) : least - 1);
  };
  return box;
}

QWidget* AttributeEditor::makeNumberBox(const AttributeDefinition& definition) {
  auto* box = new QDoubleSpinBox(this);
  constexpr int kDecimals = 4;
  const double step = std::pow(10.0, -kDecimals);
  box->setDecimals(kDecimals);
  box->setRange(definition.minimum - step, definition.maximum);
  box->setSingleStep(std::clamp((definition.maximum - definition.minimum) / 20.0, step, 0.1));
  box->setSpecialValueText(kDiffers);
  box->setSuffix(definition.unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(definition.unit));
  connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this, least = definition.minimum](double value) {
            if (value >= least) emit edited(AttributeValue(value));
          });
  show_ = [box, least = definition.minimum - step](const std::optional<AttributeValue>& value) {
    const QSignalBlocker block(box);
    box->setValue(value ? numberOf(*value) : least);
  };
  return box;
}

QWidget* AttributeEditor::makeComboBox(const AttributeDefinition& definition) {
  auto* box = new QComboBox(this);
  for (const std::string& choice : definition.choices) box->addItem(QString::fromStdString(choice));
  connect(box, QOverload<int>::of(&QComboBox::activated), this,
          [this, box] { emit edited(AttributeValue(box->currentText().toStdString())); });
  show_ = [box](const std::optional<AttributeValue>& value) {
    const QSignalBlocker block(box);
    box->setCurrentIndex(value ? box->findText(textOf(*value)) : -1);
  };
  return box;
}

QWidget* AttributeEditor::makeLine() {
  auto* line = new QLineEdit(this);
  connect(line, &QLineEdit::editingFinished, this, [this, line] {
    if (!line->isModified()) return;
    line->setModified(false);
    emit edited(AttributeValue(line->text().toStdString()));
  });
  show_ = [line](const std::optional<AttributeValue>& value) {
    if (line->hasFocus() && line->isModified()) return;
    line->setText(value ? textOf(*value) : QString());
    line->setPlaceholderText(value ? QString() : kDiffers);
  };
  return line;
}

}  // namespace glissade
