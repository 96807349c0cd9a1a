#include "widgets/places/semantics_panel.h"

#include <QHBoxLayout>
#include <QInputDialog>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/places/attribute_dialog.h"

namespace glissade {

SemanticsPanel::SemanticsPanel(SemanticDocument& document, const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      document_(document),
      actions_(actions),
      filter_(new QLineEdit(this)),
      identifier_(new QComboBox(this)),
      busy_(new QProgressBar(this)),
      tree_(new SemanticsTree(document, this)),
      attributes_(new AttributeView(document, this)),
      warning_(new QLabel(this)),
      removeStrays_(new QToolButton(this)),
      refusal_(new QLabel(this)) {
  filter_->setPlaceholderText(tr("Filter by name or value"));
  filter_->setAccessibleName(filter_->placeholderText());
  filter_->setClearButtonEnabled(true);
  const PlaceIdentifierRegistry identifiers = makePlaceIdentifierRegistry();
  for (const PlaceIdentifierEntry& entry : identifiers.entries()) {
    identifier_->addItem(engineText(entry.label), QString::fromStdString(entry.id));
    identifier_->setItemData(identifier_->count() - 1, engineText(entry.description), Qt::ToolTipRole);
  }
  identifier_->setToolTip(tr("How the places are found"));
  identifier_->setAccessibleName(identifier_->toolTip());
  tree_->setAccessibleName(tr("Places and bodies"));
  attributes_->setAccessibleName(tr("Attributes of the selection"));
  connect(identifier_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit identifierChosen(identifier_->currentData().toString().toStdString()); });
  busy_->setRange(0, 0);
  busy_->setTextVisible(false);
  busy_->setMaximumHeight(4);
  busy_->hide();
  warning_->setTextFormat(Qt::PlainText);
  warning_->setWordWrap(true);
  warning_->setObjectName(QStringLiteral("edit-warning"));
  warning_->hide();
  removeStrays_->setDefaultAction(actions[QStringLiteral("attribute.remove-strays")]);
  removeStrays_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  removeStrays_->hide();
  refusal_->setTextFormat(Qt::PlainText);
  refusal_->setWordWrap(true);
  refusal_->setObjectName(QStringLiteral("refusal"));
  refusal_->hide();
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->addWidget(tree_);
  splitter->addWidget(attributes_);
  splitter->setChildrenCollapsible(false);
  splitter->setStretchFactor(0, 1);
  splitter->setStretchFactor(1, 1);
  tree_->setMinimumWidth(200);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  actions[QStringLiteral("attribute.add")]->setIconText(tr("Add"));
  layout->addLayout(
      makeActionFlow(actions, {"environment.build", "attribute.add", "attribute.rename", "attribute.remove"}, this));
  auto* finding = new QHBoxLayout;
  finding->addWidget(filter_, 1);
  finding->addWidget(identifier_);
  layout->addLayout(finding);
  layout->addWidget(busy_);
  layout->addWidget(splitter, 1);
  layout->addWidget(warning_);
  layout->addWidget(removeStrays_, 0, Qt::AlignRight);
  layout->addWidget(refusal_);
  connect(filter_, &QLineEdit::textChanged, tree_, &SemanticsTree::setFilter);
  connect(tree_, &SemanticsTree::refused, this, &SemanticsPanel::showRefusal);
  connect(attributes_, &AttributeView::refused, this, &SemanticsPanel::showRefusal);
  connect(attributes_, &QTreeWidget::currentItemChanged, this, &SemanticsPanel::enableActions);
  connect(&document_, &SemanticDocument::changed, this, [this] {
    refusal_->hide();
    showWarnings();
    enableActions();
  });
  enableActions();
}

void SemanticsPanel::setBusy(bool busy) { busy_->setVisible(busy); }

void SemanticsPanel::setIdentifier(const std::string& id) {
  const QSignalBlocker block(identifier_);
  identifier_->setCurrentIndex(identifier_->findData(QString::fromStdString(id)));
}

void SemanticsPanel::enableActions() {
  const AttributeDefinition* current = document_.table().find(attributes_->owner(), attributes_->currentAttribute());
  const bool users = current != nullptr && !current->builtIn;
  actions_[QStringLiteral("attribute.rename")]->setEnabled(users);
  actions_[QStringLiteral("attribute.remove")]->setEnabled(users);
  actions_[QStringLiteral("attribute.remove-strays")]->setEnabled(document_.hasStrays());
}

/// Shows the first warning; the tooltip shows all of them.
void SemanticsPanel::showWarnings() {
  const Warnings& warnings = document_.warnings();
  warning_->setVisible(!warnings.empty());
  removeStrays_->setVisible(document_.hasStrays());
  if (warnings.empty()) return;
  QStringList texts;
  for (const Diagnostic& warning : warnings) texts << diagnosticLine(warning);
  warning_->setToolTip(texts.join(QLatin1Char('\n')));
  warning_->setText(QStringLiteral("⚠ ") + (texts.size() == 1
                                                ? texts.front()
                                                : tr("%1 And %n more.", "", texts.size() - 1).arg(texts.front())));
}

void SemanticsPanel::showRefusal(const Diagnostic& why) {
  refusal_->setText(diagnosticText(why));
  refusal_->show();
}

void SemanticsPanel::addAttribute() {
  AttributeDialog dialog(
      attributes_->owner(),
      [this](const AttributeDefinition& definition) { return document_.addDefinition(definition); }, this);
  dialog.exec();
}

void SemanticsPanel::renameAttribute() {
  const std::string from = attributes_->currentAttribute();
  bool accepted = false;
  const QString to = QInputDialog::getText(this, tr("Rename the attribute"), tr("New name"), QLineEdit::Normal,
                                           QString::fromStdString(from), &accepted);
  if (!accepted) return;
  const Outcome renamed = document_.renameDefinition(attributes_->owner(), from, to.trimmed().toStdString());
  if (!renamed) showRefusal(renamed.error());
}

void SemanticsPanel::removeAttribute() {
  const Outcome removed = document_.removeDefinition(attributes_->owner(), attributes_->currentAttribute());
  if (!removed) showRefusal(removed.error());
}

}  // namespace glissade
