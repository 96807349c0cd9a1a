#include "widgets/places/attribute_view.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

/// A spin box (`Box`: QSpinBox or QDoubleSpinBox) whose minimum lies one step below its least value and is shown as its
/// special text: neither steps nor typing reach it.
template <class Box, class Number>
class RangeBox : public Box {
 public:
  RangeBox(Number least, QWidget* parent) : Box(parent), least_(least) {}

  bool isInRange() const { return this->value() >= least_; }
  void stepBy(int steps) override {
    if (isInRange() && this->value() + steps * this->singleStep() >= least_) {
      Box::stepBy(steps);
    } else if (isInRange() || steps > 0) {
      this->setValue(least_);
    }
  }

 protected:
  QAbstractSpinBox::StepEnabled stepEnabled() const override {
    const auto enabled = Box::stepEnabled();
    return this->value() > least_ ? enabled
                                  : enabled & ~QAbstractSpinBox::StepEnabled(QAbstractSpinBox::StepDownEnabled);
  }
  QValidator::State validate(QString& text, int& position) const override {
    const QValidator::State state = Box::validate(text, position);
    const bool number = state == QValidator::Acceptable && text != this->specialValueText();
    return number && this->valueFromText(text) < least_ ? QValidator::Intermediate : state;
  }

 private:
  Number least_;
};

/// Shows numbers without zeros at their ends.
class ShortNumberBox final : public RangeBox<QDoubleSpinBox, double> {
 public:
  using RangeBox::RangeBox;

  QString textFromValue(double value) const override {
    QString text = RangeBox::textFromValue(value);
    if (!text.contains(locale().decimalPoint())) return text;
    while (text.endsWith(locale().zeroDigit())) text.chop(1);
    if (text.endsWith(locale().decimalPoint())) text.chop(1);
    return text;
  }
};

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

constexpr int kResetColumn = 3;

QString sourceText(Provenance provenance) {
  switch (provenance) {
    case Provenance::Initial: return AttributeView::tr("default");
    case Provenance::Computed: return AttributeView::tr("computed");
    case Provenance::Inherited: return AttributeView::tr("of its assembly");
    case Provenance::Edited: return AttributeView::tr("edited");
  }
  return {};
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
  editor->setToolTip(engineText(definition.description));
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
  return connected(box, definition, definition.unit);
}

QWidget* AttributeEditor::makeNumberBox(const AttributeDefinition& definition) {
  const bool isLength = definition.unit == "m";
  const LengthField field = lengthField(kFinestLength);
  const double scale = isLength ? field.perMetre : 1.0;
  constexpr int kDecimals = 6;
  const int decimals = isLength ? field.decimals : kDecimals;
  const double least = scale * definition.minimum;
  const double most = scale * definition.maximum;
  const double finest = std::pow(10.0, -decimals);
  auto* box = isLength ? new RangeBox<QDoubleSpinBox, double>(least, this) : new ShortNumberBox(least, this);
  box->setDecimals(decimals);
  box->setRange(least - finest, most);
  box->setSingleStep(std::clamp((most - least) / 20.0, finest, scale * 0.1));
  return connected(box, definition, isLength ? field.unit.toStdString() : definition.unit, scale);
}

/// The value below the range stands for different values, or for an unknown one; the box shows `scale` times the value.
template <typename Box>
QWidget* AttributeEditor::connected(Box* box, const AttributeDefinition& definition, const std::string& unit,
                                    double scale) {
  using Number = decltype(box->value());
  box->setSuffix(unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(unit));
  connect(box, QOverload<Number>::of(&Box::valueChanged), this, [this, box, scale](Number value) {
    if (box->isInRange()) emit edited(AttributeValue(static_cast<double>(value) / scale));
  });
  connect(box, &Box::editingFinished, this, &AttributeEditor::finished);
  // A mass of 0 is not known.
  const QString zero = definition.name == "mass" ? tr("by volume") : QString();
  show_ = [box, scale, zero](const std::optional<AttributeValue>& value) {
    const QSignalBlocker block(box);
    const bool isSpecial = !value || (!zero.isEmpty() && numberOf(*value) == 0.0);
    box->setSpecialValueText(value ? zero : kDiffers);
    const double number = isSpecial ? box->minimum() : scale * numberOf(*value);
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

AttributeView::AttributeView(SemanticDocument& document, QWidget* parent) : QTreeWidget(parent), document_(document) {
  setObjectName(QStringLiteral("attributes"));
  setColumnCount(4);
  setHeaderLabels({tr("Attribute"), tr("Value"), tr("Source"), QString()});
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setSelectionMode(QAbstractItemView::SingleSelection);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(1, QHeaderView::Stretch);
  header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(kResetColumn, QHeaderView::Fixed);
  header()->resizeSection(kResetColumn, 26);
  connect(&document_, &SemanticDocument::changed, this, &AttributeView::refresh);
  connect(&document_, &SemanticDocument::selectionChanged, this, &AttributeView::refresh);
}

std::string AttributeView::currentAttribute() const {
  const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.item == currentItem(); });
  return row == rows_.end() ? std::string() : row->attribute;
}

void AttributeView::refresh() {
  std::vector<AttributeDefinition> definitions;
  if (!(document_.selection() == SemanticSelection{})) {
    for (const AttributeDefinition& definition : document_.table().definitions()) {
      if (definition.owner == owner()) definitions.push_back(definition);
    }
  }
  // Rows are kept as long as possible, so that an editor in use keeps the focus.
  if (definitions != shown_) rebuild(definitions);
  for (Row& row : rows_) showValues(row);
}

void AttributeView::rebuild(const std::vector<AttributeDefinition>& definitions) {
  clear();
  rows_.clear();
  shown_ = definitions;
  for (const AttributeDefinition& definition : definitions) addRow(definition);
  QWidget* before = this;
  for (const Row& row : rows_) {
    setTabOrder(before, row.editor->focusProxy());
    before = row.editor->focusProxy();
  }
}

void AttributeView::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() != QEvent::LocaleChange) return;
  rebuild({});  // the unit of fields of lengths has changed
  refresh();
}

void AttributeView::keyPressEvent(QKeyEvent* event) {
  const bool edits = event->key() == Qt::Key_F2 || event->key() == Qt::Key_Space || event->key() == Qt::Key_Return ||
                     event->key() == Qt::Key_Enter;
  QWidget* editor = edits && currentItem() != nullptr ? itemWidget(currentItem(), 1) : nullptr;
  if (editor == nullptr) {
    QTreeWidget::keyPressEvent(event);
  } else {
    editor->setFocus(Qt::TabFocusReason);
  }
}

void AttributeView::addRow(const AttributeDefinition& definition) {
  auto* item = new QTreeWidgetItem(this);
  item->setText(0, engineText(definition.label));
  item->setToolTip(0, engineText(definition.description));
  auto* editor = new AttributeEditor(definition);
  setItemWidget(item, 1, editor);
  connect(editor, &AttributeEditor::edited, this,
          [this, name = definition.name](const AttributeValue& value) { set(name, value); });
  connect(editor, &AttributeEditor::finished, &document_, &SemanticDocument::endGesture);
  rows_.push_back({definition.name, editor, item});
}

/// The button exists only if there is an edit to remove.
void AttributeView::showReset(const Row& row, bool visible) {
  if (visible == (itemWidget(row.item, kResetColumn) != nullptr)) return;
  if (!visible) {
    removeItemWidget(row.item, kResetColumn);
    return;
  }
  auto* reset = new QToolButton;
  reset->setText(QStringLiteral("↺"));
  reset->setAutoRaise(true);
  reset->setToolTip(tr("Remove the edit and use the computed value"));
  connect(reset, &QToolButton::clicked, this, [this, name = row.attribute] { set(name, std::nullopt); });
  setItemWidget(row.item, kResetColumn, reset);
  setTabOrder(row.editor->focusProxy(), reset);
}

void AttributeView::set(const std::string& attribute, const std::optional<AttributeValue>& value) {
  const Outcome outcome = document_.setAttribute(document_.selection().shown(), attribute, value);
  if (outcome) return;
  emit refused(outcome.error());
  refresh();
}

std::vector<ProvenValue> AttributeView::valuesOf(const std::string& attribute) const {
  std::vector<ProvenValue> values;
  const SemanticSelection shown = document_.selection().shown();
  for (const QString& body : shown.bodies) values.push_back(document_.bodyValue(body, attribute));
  for (const int place : shown.places) {
    if (const SemanticModel* semantics = document_.semantics()) {
      values.push_back(semantics->ofPlace(static_cast<std::size_t>(place), attribute));
    }
  }
  return values;
}

void AttributeView::showValues(Row& row) {
  const std::vector<ProvenValue> values = valuesOf(row.attribute);
  if (values.empty()) return;
  const bool same = std::all_of(values.begin(), values.end(),
                                [&](const ProvenValue& value) { return value.value == values.front().value; });
  const bool anyEdited = std::any_of(values.begin(), values.end(),
                                     [](const ProvenValue& value) { return value.provenance == Provenance::Edited; });
  const bool oneSource = std::all_of(values.begin(), values.end(), [&](const ProvenValue& value) {
    return value.provenance == values.front().provenance;
  });
  row.editor->setValue(same ? std::optional<AttributeValue>(values.front().value) : std::nullopt);
  row.item->setText(2, oneSource ? sourceText(values.front().provenance) : QStringLiteral("—"));
  QFont font = row.item->font(2);
  font.setBold(anyEdited);
  row.item->setFont(2, font);
  showReset(row, anyEdited);
}

}  // namespace glissade
