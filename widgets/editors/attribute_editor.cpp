#include "widgets/editors/attribute_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "widgets/commands/length_text.h"

namespace glissade {
namespace {

constexpr double kFinestLength = 1e-5;  ///< metres

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
  editor->setFocusPolicy(Qt::StrongFocus);
  editor->installEventFilter(this);
  setFocusProxy(editor);
  layout->addWidget(editor);
}

void AttributeEditor::setValue(const std::optional<AttributeValue>& value) { show_(value); }

bool AttributeEditor::eventFilter(QObject* watched, QEvent* event) {
  const bool scrolls = event->type() == QEvent::Wheel && !focusProxy()->hasFocus();
  const auto* key = event->type() == QEvent::ShortcutOverride ? static_cast<QKeyEvent*>(event) : nullptr;
  const bool undoes = key != nullptr && (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo));
  if (!scrolls && !undoes) return QWidget::eventFilter(watched, event);
  event->ignore();
  return true;
}

QWidget* AttributeEditor::makeCheckBox() {
  auto* box = new QCheckBox(this);
  connect(box, &QCheckBox::clicked, this, [this, box] {
    box->setTristate(false);
    emit edited(AttributeValue(box->isChecked()));
    emit finished();
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

QWidget* AttributeEditor::makeSpinBox(const AttributeDefinition& definition) {
  const int least = static_cast<int>(std::max(definition.minimum, -1e9));
  const int most = static_cast<int>(std::min(definition.maximum, 1e9));
  auto* box = new RangeBox<QSpinBox, int>(least, this);
  box->setRange(least - 1, most);
  return connected(box, definition.unit);
}

QWidget* AttributeEditor::makeNumberBox(const AttributeDefinition& definition) {
  const bool isLength = definition.unit == "m";
  const LengthField field = lengthField(kFinestLength);
  const double scale = isLength ? field.perMetre : 1.0;
  const int decimals = isLength ? field.decimals : 4;
  const double least = scale * definition.minimum;
  const double most = scale * definition.maximum;
  const double finest = std::pow(10.0, -decimals);
  auto* box = new RangeBox<QDoubleSpinBox, double>(least, this);
  box->setDecimals(decimals);
  box->setRange(least - finest, most);
  box->setSingleStep(std::clamp((most - least) / 20.0, finest, scale * 0.1));
  return connected(box, isLength ? field.unit.toStdString() : definition.unit, scale);
}

/// The value below the range stands for "different"; what is shown is `scale` times the value.
template <class Box, class Number>
QWidget* AttributeEditor::connected(RangeBox<Box, Number>* box, const std::string& unit, double scale) {
  box->setSpecialValueText(kDiffers);
  box->setSuffix(unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(unit));
  connect(box, QOverload<Number>::of(&Box::valueChanged), this, [this, box, scale](Number value) {
    if (box->isInRange()) emit edited(AttributeValue(static_cast<double>(value) / scale));
  });
  connect(box, &Box::editingFinished, this, &AttributeEditor::finished);
  show_ = [box, scale](const std::optional<AttributeValue>& value) {
    const QSignalBlocker block(box);
    const double number = value ? scale * numberOf(*value) : box->minimum();
    box->setValue(std::is_integral_v<Number> ? static_cast<Number>(std::lround(number)) : static_cast<Number>(number));
  };
  return box;
}

QWidget* AttributeEditor::makeComboBox(const AttributeDefinition& definition) {
  auto* box = new QComboBox(this);
  for (const std::string& choice : definition.choices) box->addItem(QString::fromStdString(choice));
  connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box] {
    emit edited(AttributeValue(box->currentText().toStdString()));
    emit finished();
  });
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
    emit finished();
  });
  show_ = [line](const std::optional<AttributeValue>& value) {
    if (line->hasFocus() && line->isModified()) return;
    line->setText(value ? textOf(*value) : QString());
    line->setPlaceholderText(value ? QString() : kDiffers);
  };
  return line;
}

}  // namespace glissade
