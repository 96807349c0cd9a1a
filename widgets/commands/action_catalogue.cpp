#include "widgets/commands/action_catalogue.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QToolButton>

#include <utility>

#include "widgets/commands/action_help.h"
#include "widgets/commands/flow_layout.h"

namespace glissade {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("Actions", text); }

/// What a button says where its panel or its icon tells what it is about; menus and commands have the whole text.
constexpr std::pair<const char*, const char*> kButtonTexts[] = {
    {"file.open", QT_TRANSLATE_NOOP("Actions", "Open")},
    {"file.save", QT_TRANSLATE_NOOP("Actions", "Save")},
    {"file.export", QT_TRANSLATE_NOOP("Actions", "Export")},
    {"run.start", QT_TRANSLATE_NOOP("Actions", "Start")},
    {"run.pause", QT_TRANSLATE_NOOP("Actions", "Pause")},
    {"run.stop", QT_TRANSLATE_NOOP("Actions", "Stop")},
    {"run.restart-new-seed", QT_TRANSLATE_NOOP("Actions", "New seed")},
    {"work.cancel", QT_TRANSLATE_NOOP("Actions", "Cancel")},
    {"path.first-blocked", QT_TRANSLATE_NOOP("Actions", "Where is it blocked?")},
    {"view.path-authors", QT_TRANSLATE_NOOP("Actions", "Path by author")},
    {"study.zoom-out", QT_TRANSLATE_NOOP("Actions", "Whole plot")},
    {"refusal.allow", QT_TRANSLATE_NOOP("Actions", "Allow as fits")},
    {"joints.confirm", QT_TRANSLATE_NOOP("Actions", "Confirm")},
    {"joints.confirm-all", QT_TRANSLATE_NOOP("Actions", "Confirm all")},
    {"joints.dissolve", QT_TRANSLATE_NOOP("Actions", "Dissolve")},
    {"joints.make", QT_TRANSLATE_NOOP("Actions", "Make...")},
    {"assembly.align", QT_TRANSLATE_NOOP("Actions", "Align")},
    {"assembly.snap", QT_TRANSLATE_NOOP("Actions", "Snap")},
    {"assembly.flip", QT_TRANSLATE_NOOP("Actions", "Flip")},
    {"place.forbid", QT_TRANSLATE_NOOP("Actions", "Forbid place")},
    {"place.prefer", QT_TRANSLATE_NOOP("Actions", "Prefer place")},
    {"milestone.set", QT_TRANSLATE_NOOP("Actions", "Set milestone")},
    {"milestone.reset", QT_TRANSLATE_NOOP("Actions", "Reset milestone")},
    {"attribute.rename", QT_TRANSLATE_NOOP("Actions", "Rename...")},
    {"attribute.remove", QT_TRANSLATE_NOOP("Actions", "Remove")},
};

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

ActionCatalogue::ActionCatalogue(QObject* parent) : QObject(parent) {
  for (const ActionSpec& spec : actionSpecs()) {
    auto* action = new QAction(translated(spec.text), this);
    action->setObjectName(QLatin1String(spec.id));
    action->setCheckable(spec.checkable);
    action->setStatusTip(translated(spec.tip));
    actions_.insert(QLatin1String(spec.id), action);
    setShortcut(QLatin1String(spec.id), QKeySequence(QLatin1String(spec.shortcut)));
  }
  for (const auto& [id, text] : kButtonTexts) actions_.value(QLatin1String(id))->setIconText(translated(text));
}

void ActionCatalogue::setShortcut(const QString& id, const QKeySequence& keys) {
  QAction* action = actions_.value(id);
  action->setShortcut(keys);
  QString tip = action->statusTip();
  if (!keys.isEmpty()) tip += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
  action->setToolTip(tip);
  action->setWhatsThis(
      actionHelp(id, withoutMnemonic(action->text()), keys.toString(QKeySequence::NativeText), action->statusTip()));
}

QKeySequence ActionCatalogue::usualShortcut(const QString& id) {
  for (const ActionSpec& spec : actionSpecs()) {
    if (id == QLatin1String(spec.id)) return QKeySequence(QLatin1String(spec.shortcut));
  }
  return {};
}

QString ActionCatalogue::shortcutTable() const {
  QString rows;
  for (const ActionSpec& spec : actionSpecs()) {
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
