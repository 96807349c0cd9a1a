#include "widgets/places/rules_dialog.h"

#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "engine/planning/planner.h"
#include "widgets/controls/diagnostic_text.h"

namespace glissade {
namespace {

constexpr const char* kPresets[] = {"gt", "gts1", "gts2", "gts"};

enum Column { kWhen, kGeometrical, kLocal };

}  // namespace

RulesDialog::RulesDialog(const StrategyRules& own, AttributeTable table, QWidget* parent)
    : QDialog(parent),
      table_(std::move(table)),
      preset_(new QComboBox(this)),
      node_(makeFunction("rule-node", tr("f: what a border costs where places a and b meet. Known: %1")
                                          .arg(QStringLiteral("size, a.…, b.…, object.…")))),
      edge_(makeFunction("rule-edge", tr("g: what a path across a place costs. Known: %1")
                                          .arg(QStringLiteral("distance, size, place.…, object.…")))),
      fine_(new QTableWidget(0, 3, this)),
      loop_(new QCheckBox(tr("When a step fails, try the &next best path"), this)),
      fitted_(new QCheckBox(tr("&Cross passages as the object fits best"), this)),
      trouble_(new QLabel(this)) {
  setWindowTitle(tr("Rules of the strategy"));
  setObjectName(QStringLiteral("rules"));
  resize(620, 560);
  setUpFine();
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Borders: f ="), node_);
  form->addRow(tr("Pa&ths: g ="), edge_);
  auto* known = new QLabel(names(), this);
  known->setWordWrap(true);
  known->setTextInteractionFlags(Qt::TextSelectableByMouse);
  form->addRow(tr("Attributes"), known);
  auto* planners = new QLabel(tr("&Planners: the first row that holds decides; the last must always hold (1)."), this);
  planners->setBuddy(fine_);
  trouble_->setTextFormat(Qt::PlainText);
  trouble_->setWordWrap(true);
  trouble_->setObjectName(QStringLiteral("trouble"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  accept_ = buttons->button(QDialogButtonBox::Ok);
  accept_->setText(tr("&Use as own rules"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addLayout(makeBeginning());
  column->addLayout(form);
  column->addWidget(planners);
  column->addWidget(fine_, 1);
  column->addLayout(makeFineButtons());
  column->addWidget(loop_);
  column->addWidget(fitted_);
  column->addWidget(trouble_);
  column->addWidget(buttons);
  show(own);
}

/// A field with two lines for an expression; Tab moves the focus.
QPlainTextEdit* RulesDialog::makeFunction(const char* id, const QString& tip) {
  auto* text = new QPlainTextEdit(this);
  text->setObjectName(QLatin1String(id));
  text->setToolTip(tip);
  text->setTabChangesFocus(true);
  text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  text->setFixedHeight(3 * text->fontMetrics().lineSpacing() + 12);
  connect(text, &QPlainTextEdit::textChanged, this, &RulesDialog::check);
  return text;
}

QLayout* RulesDialog::makeBeginning() {
  auto* row = new QHBoxLayout;
  preset_->addItem(tr("Own rules"));
  for (const char* id : kPresets) preset_->addItem(QString::fromLatin1(id).toUpper(), QLatin1String(id));
  preset_->setObjectName(QStringLiteral("preset"));
  preset_->setToolTip(tr("Read a strategy of the paper, or ours, and begin with it"));
  auto* label = new QLabel(tr("Be&gin with"), this);
  label->setBuddy(preset_);
  row->addWidget(label);
  row->addWidget(preset_);
  row->addStretch();
  connect(preset_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    if (index > 0) show(presetRules(preset_->itemData(index).toString().toStdString()));
  });
  return row;
}

void RulesDialog::setUpFine() {
  fine_->setObjectName(QStringLiteral("fine-rules"));
  fine_->setAccessibleName(tr("Rules of the fine planners"));
  fine_->setHorizontalHeaderLabels({tr("Where"), tr("In a region"), tr("Local planner")});
  fine_->horizontalHeaderItem(kGeometrical)
      ->setToolTip(tr("The geometrical planner first finds cells that the local planner stays in"));
  fine_->horizontalHeader()->setSectionResizeMode(kWhen, QHeaderView::Stretch);
  fine_->horizontalHeader()->setSectionResizeMode(kGeometrical, QHeaderView::ResizeToContents);
  fine_->horizontalHeader()->setSectionResizeMode(kLocal, QHeaderView::ResizeToContents);
  fine_->verticalHeader()->hide();
  fine_->setSelectionBehavior(QAbstractItemView::SelectRows);
  fine_->setSelectionMode(QAbstractItemView::SingleSelection);
  fine_->setTabKeyNavigation(false);
  connect(fine_, &QTableWidget::itemChanged, this, &RulesDialog::check);
}

QLayout* RulesDialog::makeFineButtons() {
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const QString& tip, auto handler) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, handler);
    row->addWidget(button);
  };
  add(tr("&Add"), tr("A rule before the current one"), [this] {
    addFine(std::max(0, fine_->currentRow()), {"place.complexity > 3", false, "rrt"});
    check();
  });
  add(tr("&Remove"), tr("The current rule"), [this] {
    fine_->removeRow(fine_->currentRow());
    check();
  });
  add(tr("&Up"), tr("The current rule is asked earlier"), [this] { moveFine(-1); });
  add(tr("&Down"), tr("The current rule is asked later"), [this] { moveFine(1); });
  row->addStretch();
  return row;
}

QString RulesDialog::names() const {
  QStringList ofPlaces;
  QStringList ofBodies;
  for (const AttributeDefinition& definition : table_.definitions()) {
    (definition.owner == AttributeOwner::Place ? ofPlaces : ofBodies) << QString::fromStdString(definition.name);
  }
  return tr("of places (place., a., b.): %1; of the object (object.): %2")
      .arg(ofPlaces.join(QStringLiteral(", ")), ofBodies.join(QStringLiteral(", ")));
}

void RulesDialog::show(const StrategyRules& rules) {
  {
    const QSignalBlocker blockNode(node_);
    const QSignalBlocker blockEdge(edge_);
    node_->setPlainText(QString::fromStdString(rules.node));
    edge_->setPlainText(QString::fromStdString(rules.edge));
    loop_->setChecked(rules.loop);
    fitted_->setChecked(rules.fitted);
    fine_->setRowCount(0);
    for (const FineRule& rule : rules.fine) addFine(fine_->rowCount(), rule);
  }
  check();
}

void RulesDialog::addFine(int row, const FineRule& rule) {
  const QSignalBlocker block(fine_);
  fine_->insertRow(row);
  fine_->setItem(row, kWhen, new QTableWidgetItem(QString::fromStdString(rule.when)));
  auto* geometrical = new QTableWidgetItem;
  geometrical->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  geometrical->setCheckState(rule.geometrical ? Qt::Checked : Qt::Unchecked);
  fine_->setItem(row, kGeometrical, geometrical);
  auto* local = new QComboBox(fine_);
  for (const std::string& id : idsOf(makeLocalPlannerRegistry())) local->addItem(QString::fromStdString(id));
  local->setCurrentText(QString::fromStdString(rule.local));
  fine_->setCellWidget(row, kLocal, local);
  fine_->setCurrentCell(row, kWhen);
}

void RulesDialog::moveFine(int by) {
  const int row = fine_->currentRow();
  const int target = row + by;
  if (row < 0 || target < 0 || target >= fine_->rowCount()) return;
  const FineRule rule = fineAt(row);
  fine_->removeRow(row);
  addFine(target, rule);
  check();
}

FineRule RulesDialog::fineAt(int row) const {
  return {fine_->item(row, kWhen)->text().toStdString(), fine_->item(row, kGeometrical)->checkState() == Qt::Checked,
          qobject_cast<QComboBox*>(fine_->cellWidget(row, kLocal))->currentText().toStdString()};
}

StrategyRules RulesDialog::rules() const {
  StrategyRules rules;
  rules.node = node_->toPlainText().simplified().toStdString();
  rules.edge = edge_->toPlainText().simplified().toStdString();
  for (int row = 0; row < fine_->rowCount(); ++row) rules.fine.push_back(fineAt(row));
  rules.loop = loop_->isChecked();
  rules.fitted = fitted_->isChecked();
  return rules;
}

bool RulesDialog::isSound() const { return parseRules(rules(), table_, idsOf(makeLocalPlannerRegistry())).ok(); }

void RulesDialog::check() {
  if (accept_ == nullptr) return;  // the dialog is not complete yet
  const auto parsed = parseRules(rules(), table_, idsOf(makeLocalPlannerRegistry()));
  accept_->setEnabled(parsed.ok());
  trouble_->setText(parsed ? QString() : diagnosticLine(parsed.error()));
}

}  // namespace glissade
