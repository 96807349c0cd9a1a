#include "widgets/editors/attribute_view.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QToolButton>

#include <algorithm>

namespace glissade {
namespace {

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
  // The rows stay as long as they can, so that an editor in use keeps the focus.
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
  rebuild({});  // fields of lengths have another unit
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
  item->setText(0, QCoreApplication::translate("Attributes", definition.label.c_str()));
  item->setToolTip(0, QCoreApplication::translate("Attributes", definition.description.c_str()));
  auto* editor = new AttributeEditor(definition);
  setItemWidget(item, 1, editor);
  connect(editor, &AttributeEditor::edited, this,
          [this, name = definition.name](const AttributeValue& value) { set(name, value); });
  connect(editor, &AttributeEditor::finished, &document_, &SemanticDocument::endGesture);
  rows_.push_back({definition.name, editor, item});
}

/// The button is only there where there is something to take back.
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
