#include "widgets/controls/action_catalogue.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QToolButton>

#include <algorithm>
#include <utility>

#include "widgets/controls/flow_layout.h"

namespace glissade {
namespace {

/// The text of "What's this?" on an action, as rich text: its name, shortcut and tip, and its further help.
QString actionHelp(const QAction& action, const char* more) {
  const QString keys = action.shortcut().toString(QKeySequence::NativeText);
  QString name = withoutMnemonic(action.text()).toHtmlEscaped();
  if (!keys.isEmpty()) name += QStringLiteral(" (%1)").arg(keys.toHtmlEscaped());
  QString help = QStringLiteral("<b>%1</b><p>%2.</p>").arg(name, action.statusTip().toHtmlEscaped());
  if (more[0] == '\0') return help;
  return help + QStringLiteral("<p>%1</p>").arg(QCoreApplication::translate("ActionHelp", more).toHtmlEscaped());
}

QString translated(const char* text) { return QCoreApplication::translate("Actions", text); }

void addActionButtons(QLayout& layout, const ActionCatalogue& actions, const std::vector<const char*>& ids,
                      QWidget* parent) {
  for (const char* id : ids) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(actions[QLatin1String(id)]);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    layout.addWidget(button);
  }
}

}  // namespace

ActionCatalogue::ActionCatalogue(std::vector<ActionSpec> specs, QObject* parent)
    : QObject(parent), specs_(std::move(specs)) {
  for (const ActionSpec& spec : specs_) {
    auto* action = new QAction(translated(spec.text), this);
    action->setObjectName(QLatin1String(spec.id));
    action->setCheckable(spec.checkable);
    action->setStatusTip(translated(spec.tip));
    if (spec.button[0] != '\0') action->setIconText(translated(spec.button));
    actions_.insert(QLatin1String(spec.id), action);
    setShortcut(QLatin1String(spec.id), QKeySequence(QLatin1String(spec.key)));
  }
}

const ActionSpec& ActionCatalogue::specOf(const QString& id) const {
  return *std::find_if(specs_.begin(), specs_.end(),
                       [&](const ActionSpec& spec) { return id == QLatin1String(spec.id); });
}

void ActionCatalogue::setShortcut(const QString& id, const QKeySequence& keys) {
  QAction* action = actions_.value(id);
  action->setShortcut(keys);
  QString tip = action->statusTip();
  if (!keys.isEmpty()) tip += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
  action->setToolTip(tip);
  action->setWhatsThis(actionHelp(*action, specOf(id).help));
}

QKeySequence ActionCatalogue::usualShortcut(const QString& id) const {
  return QKeySequence(QLatin1String(specOf(id).key));
}

QString ActionCatalogue::shortcutTable() const {
  QString rows;
  for (const ActionSpec& spec : specs_) {
    const QAction* action = actions_.value(QLatin1String(spec.id));
    if (action->shortcut().isEmpty()) continue;
    rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td><td>&nbsp;&nbsp;%3</td></tr>")
                .arg(action->shortcut().toString(QKeySequence::NativeText), withoutMnemonic(action->text()),
                     translated(spec.tip));
  }
  return rows;
}

QHBoxLayout* makeActionRow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  addActionButtons(*row, actions, ids, parent);
  row->addStretch();
  return row;
}

QLayout* makeActionFlow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent) {
  auto* flow = new FlowLayout;
  addActionButtons(*flow, actions, ids, parent);
  return flow;
}

}  // namespace glissade
