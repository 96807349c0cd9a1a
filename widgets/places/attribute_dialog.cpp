#include "widgets/places/attribute_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QVBoxLayout>

#include "engine/base/number_text.h"
#include "widgets/controls/diagnostic_text.h"

namespace glissade {
namespace {

bool isNumber(AttributeType type) { return type == AttributeType::Integer || type == AttributeType::Number; }

std::string textOf(const QLineEdit& line) { return line.text().trimmed().toStdString(); }

/// Reads the number; an empty line leaves `number` as it is.
Outcome readNumber(const QLineEdit& line, double& number) {
  const std::string text = textOf(line);
  if (text.empty()) return Done{};
  const auto read = toNumber(text);
  if (!read)
    return Diagnostic{ErrorKind::Usage,
                      "",
                      "",
                      {GLISSADE_TEXT("'%1' is not a number"), {text}},
                      GLISSADE_TEXT("Write it like 0.25.")};
  number = *read;
  return Done{};
}

}  // namespace

AttributeDialog::AttributeDialog(AttributeOwner owner, Add add, QWidget* parent)
    : QDialog(parent),
      add_(std::move(add)),
      name_(addLine("name", tr("lower-case letters, digits and _"))),
      type_(new QComboBox(this)),
      owner_(new QComboBox(this)),
      unit_(addLine("unit")),
      minimum_(addLine("minimum", tr("none"))),
      maximum_(addLine("maximum", tr("none"))),
      initial_(addLine("initial", tr("0, or the nearest in range"))),
      choices_(addLine("choices", tr("separated by commas"))),
      description_(addLine("description")),
      refusal_(new QLabel(this)) {
  setWindowTitle(tr("Add an attribute"));
  type_->addItem(tr("yes or no"), static_cast<int>(AttributeType::Bool));
  type_->addItem(tr("whole number"), static_cast<int>(AttributeType::Integer));
  type_->addItem(tr("number"), static_cast<int>(AttributeType::Number));
  type_->addItem(tr("text"), static_cast<int>(AttributeType::Text));
  type_->addItem(tr("choice"), static_cast<int>(AttributeType::Choice));
  type_->setObjectName(QStringLiteral("type"));
  owner_->addItem(tr("places"), static_cast<int>(AttributeOwner::Place));
  owner_->addItem(tr("bodies"), static_cast<int>(AttributeOwner::Body));
  owner_->setCurrentIndex(owner == AttributeOwner::Place ? 0 : 1);
  refusal_->setObjectName(QStringLiteral("refusal"));
  refusal_->setTextFormat(Qt::PlainText);
  refusal_->setWordWrap(true);
  auto* form = new QFormLayout;
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Type"), type_);
  form->addRow(tr("Describes"), owner_);
  form->addRow(tr("Unit"), unit_);
  form->addRow(tr("Minimum"), minimum_);
  form->addRow(tr("Maximum"), maximum_);
  form->addRow(tr("Initial value"), initial_);
  form->addRow(tr("Choices"), choices_);
  form->addRow(tr("Meaning"), description_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(refusal_);
  layout->addWidget(buttons);
  connect(type_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &AttributeDialog::enable);
  enable();
}

/// Adds a line that is as wide as its hint.
QLineEdit* AttributeDialog::addLine(const char* name, const QString& hint) {
  auto* line = new QLineEdit(this);
  line->setObjectName(QLatin1String(name));
  line->setPlaceholderText(hint);
  line->setMinimumWidth(line->fontMetrics().horizontalAdvance(hint + QStringLiteral("MM")));
  return line;
}

AttributeType AttributeDialog::type() const { return static_cast<AttributeType>(type_->currentData().toInt()); }

void AttributeDialog::enable() {
  for (QLineEdit* line : {unit_, minimum_, maximum_, initial_}) line->setEnabled(isNumber(type()));
  choices_->setEnabled(type() == AttributeType::Choice);
}

void AttributeDialog::accept() {
  const auto requested = definition();
  const Outcome added = requested ? add_(*requested) : Outcome(requested.error());
  if (added) {
    QDialog::accept();
    return;
  }
  refusal_->setText(diagnosticText(added.error()));
  adjustSize();  // a label that wraps does not request its height
}

Result<AttributeDefinition> AttributeDialog::definition() const {
  AttributeDefinition definition;
  definition.name = textOf(*name_);
  definition.label = Message(definition.name);
  definition.type = type();
  definition.owner = static_cast<AttributeOwner>(owner_->currentData().toInt());
  definition.description = Message(textOf(*description_));
  if (isNumber(type())) {
    definition.unit = textOf(*unit_);
    for (const Outcome& read : {readNumber(*minimum_, definition.minimum), readNumber(*maximum_, definition.maximum)}) {
      if (!read) return read.error();
    }
  }
  if (type() == AttributeType::Choice) {
    for (const QString& choice : choices_->text().split(QLatin1Char(','))) {
      if (!choice.trimmed().isEmpty()) definition.choices.push_back(choice.trimmed().toStdString());
    }
  }
  if (definition.minimum > definition.maximum) return definition;  // is refused, without an initial value
  definition.initial = initialValue(definition);
  if (isNumber(type())) {
    const Outcome read = readNumber(*initial_, std::get<double>(definition.initial));
    if (!read) return read.error();
  }
  return definition;
}

}  // namespace glissade
