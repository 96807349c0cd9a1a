#include "widgets/controls/action_catalogue.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QToolButton>

#include <utility>

#include "widgets/controls/flow_layout.h"

namespace glissade {
namespace {

/// Further help on actions whose tip is not enough for a person who sees them for the first time.
constexpr std::pair<const char*, const char*> kMore[] = {
    {"file.new", QT_TRANSLATE_NOOP("ActionHelp",
                                   "STEP files of a product become one row for each part, placed as the assembly has "
                                   "it. Meshes may need a unit and an axis. One part moves; the others are static or "
                                   "mobile.")},
    {"file.open", QT_TRANSLATE_NOOP("ActionHelp",
                                    "A scenario holds bodies, the object that moves, its start and goal, places, "
                                    "fits, kept paths and parameters.")},
    {"run.start", QT_TRANSLATE_NOOP("ActionHelp",
                                    "The strategy, the operator and the sliders of the panel Interaction say how. A "
                                    "path that is found is proved free of penetration. Parameters can be changed "
                                    "while the run goes on.")},
    {"run.tuning", QT_TRANSLATE_NOOP("ActionHelp",
                                     "The program changes the values while it plans, from what computer, operator "
                                     "and contact have earned lately. A slider that is touched is set by hand again.")},
    {"environment.build",
     QT_TRANSLATE_NOOP("ActionHelp",
                       "The free space is divided into cells, and cells of similar narrowness "
                       "into places. Places overlap in borders. Layers and the strategies with places plan a "
                       "coarse path through places first.")},
    {"place.forbid", QT_TRANSLATE_NOOP("ActionHelp",
                                       "The coarse path is planned again at once, also during a run. An edit of a "
                                       "place is saved with the scenario and can be undone.")},
    {"milestone.set", QT_TRANSLATE_NOOP("ActionHelp",
                                        "A milestone is a configuration in the border of two places that the path "
                                        "passes through. It can be dragged in the scene, too.")},
    {"assembly.free-ends", QT_TRANSLATE_NOOP("ActionHelp",
                                             "CAD parts touch in their assembled position. Where clearance is "
                                             "required, start or goal have to move by the distance that is found and "
                                             "stated.")},
    {"assembly.moves", QT_TRANSLATE_NOOP("ActionHelp",
                                         "The object is what moves: one body, or several as one rigid body. All other "
                                         "bodies are obstacles.")},
    {"assembly.leave-out", QT_TRANSLATE_NOOP("ActionHelp",
                                             "CAD files often hold variants of a part that are drawn over each other. "
                                             "One is built, the others are left out. Proofs are about the product "
                                             "without them.")},
    {"fits.find", QT_TRANSLATE_NOOP("ActionHelp",
                                    "Parts of a product touch or overlap as designed. A fit says by how much the "
                                    "object is taken thinner against one body, and every result states it.")},
    {"joints.find", QT_TRANSLATE_NOOP("ActionHelp",
                                      "Screws, nuts, inserts, pins and rolling bearings are recognised by their "
                                      "shapes. Belts, clips, what is glued, and purchased units are suggested and "
                                      "count when you confirm them.")},
    {"sequence.plan", QT_TRANSLATE_NOOP("ActionHelp",
                                        "Assembly is the reverse order. The plan says which step makes way for which, "
                                        "which parts have to be held, and which tool turns a fastener.")},
    {"access.sequence", QT_TRANSLATE_NOOP("ActionHelp",
                                          "Several ways to hold the part or its tool are tried, with the wrist bent in "
                                          "six ways. Hand, forearm and tool are sampled along the motion: this is no "
                                          "proof. Measures of the hand are those of ANSUR II.")},
    {"path.smooth",
     QT_TRANSLATE_NOOP("ActionHelp", "The shortened path is proved like the planned one; both are kept.")},
    {"path.sweep", QT_TRANSLATE_NOOP("ActionHelp",
                                     "The surface contains the object at every time of the path, and is nowhere "
                                     "farther from it than the stated bound.")},
    {"difficulty.find", QT_TRANSLATE_NOOP("ActionHelp",
                                          "The panel Difficulty lists the smallest distance between the two trees, "
                                          "the bodies between them, and by how much the object would have to be "
                                          "thinner.")},
    {"assist.go",
     QT_TRANSLATE_NOOP("ActionHelp",
                       "The hand is taken to a configuration that the search has reached. The ghost is the "
                       "nearest one on the other side: lead the object there. Where nobody held the "
                       "object, or the search had ended, it starts again by hand.")},
    {"replay.last", QT_TRANSLATE_NOOP("ActionHelp",
                                      "Every run is recorded with its seed, its parameters and what the operator "
                                      "did. The replay gives the same roadmap, node by node.")},
    {"operator.frame",
     QT_TRANSLATE_NOOP("ActionHelp", "It holds for keys and devices. F over the scene does the same.")},
    {"operator.camera", QT_TRANSLATE_NOOP("ActionHelp",
                                          "Keys and devices move the object as a rule. In camera mode the same input "
                                          "moves the view instead.")},
};

/// The text of "What's this?" on an action, as rich text: its name, shortcut and tip, and the text of kMore if there is
/// one.
QString actionHelp(const QString& id, const QString& text, const QString& keys, const QString& tip) {
  QString name = text.toHtmlEscaped();
  if (!keys.isEmpty()) name += QStringLiteral(" (%1)").arg(keys.toHtmlEscaped());
  QString help = QStringLiteral("<b>%1</b><p>%2.</p>").arg(name, tip.toHtmlEscaped());
  for (const auto& [about, more] : kMore) {
    if (id != QLatin1String(about)) continue;
    help += QStringLiteral("<p>%1</p>").arg(QCoreApplication::translate("ActionHelp", more).toHtmlEscaped());
  }
  return help;
}

QString translated(const char* text) { return QCoreApplication::translate("Actions", text); }

/// Short texts of buttons whose panel or icon gives the context; menus and commands have the whole text.
constexpr std::pair<const char*, const char*> kButtonTexts[] = {
    {"file.open", QT_TRANSLATE_NOOP("Actions", "Open")},
    {"file.save", QT_TRANSLATE_NOOP("Actions", "Save")},
    {"file.export", QT_TRANSLATE_NOOP("Actions", "Export")},
    {"run.start", QT_TRANSLATE_NOOP("Actions", "Start")},
    {"run.pause", QT_TRANSLATE_NOOP("Actions", "Pause")},
    {"run.stop", QT_TRANSLATE_NOOP("Actions", "Stop")},
    {"sequence.take-path", QT_TRANSLATE_NOOP("Actions", "Done")},
    {"sequence.leave-hand", QT_TRANSLATE_NOOP("Actions", "Cancel")},
    {"run.restart-new-seed", QT_TRANSLATE_NOOP("Actions", "New seed")},
    {"work.cancel", QT_TRANSLATE_NOOP("Actions", "Cancel")},
    {"path.first-blocked", QT_TRANSLATE_NOOP("Actions", "Where is it blocked?")},
    {"view.path-authors", QT_TRANSLATE_NOOP("Actions", "Path by author")},
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
