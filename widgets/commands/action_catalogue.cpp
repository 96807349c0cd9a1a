#include "widgets/commands/action_catalogue.h"

#include <QCoreApplication>
#include <QKeySequence>

namespace glissade {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("Actions", text); }

QString plain(QString text) { return text.remove(QLatin1Char('&')); }

}  // namespace

const std::vector<ActionSpec>& actionSpecs() {
  static const std::vector<ActionSpec> specs{
      {"file.open", QT_TRANSLATE_NOOP("Actions", "&Open..."), "Ctrl+O",
       QT_TRANSLATE_NOOP("Actions", "Open a scenario or an OMPL.app problem"), false},
      {"file.export", QT_TRANSLATE_NOOP("Actions", "&Export path..."), "Ctrl+E",
       QT_TRANSLATE_NOOP("Actions", "Save the certified path as CSV, JSON or OMPL columns"), false},
      {"file.quit", QT_TRANSLATE_NOOP("Actions", "&Quit"), "Ctrl+Q", QT_TRANSLATE_NOOP("Actions", "Leave Glissade"),
       false},
      {"run.start", QT_TRANSLATE_NOOP("Actions", "&Start"), "F5",
       QT_TRANSLATE_NOOP("Actions", "Plan with a fresh roadmap and the current seed"), false},
      {"run.pause", QT_TRANSLATE_NOOP("Actions", "&Pause"), "F6",
       QT_TRANSLATE_NOOP("Actions", "Hold the planner, or let it go on"), true},
      {"run.stop", QT_TRANSLATE_NOOP("Actions", "S&top"), "Shift+F5",
       QT_TRANSLATE_NOOP("Actions", "End the run; what was found stays shown"), false},
      {"run.restart", QT_TRANSLATE_NOOP("Actions", "&Restart"), "Ctrl+R",
       QT_TRANSLATE_NOOP("Actions", "Stop and start again with the same seed"), false},
      {"run.restart-new-seed", QT_TRANSLATE_NOOP("Actions", "Restart with a &new seed"), "Ctrl+Shift+R",
       QT_TRANSLATE_NOOP("Actions", "Stop and start again with the next seed"), false},
      {"object.to-start", QT_TRANSLATE_NOOP("Actions", "&Object to the start"), "Ctrl+Home",
       QT_TRANSLATE_NOOP("Actions", "Put the object in your hand back to the start"), false},
      {"path.play", QT_TRANSLATE_NOOP("Actions", "&Play the path"), "Ctrl+P",
       QT_TRANSLATE_NOOP("Actions", "Move the object along the path, or hold it"), true},
      {"view.fit", QT_TRANSLATE_NOOP("Actions", "&Fit"), "Ctrl+0",
       QT_TRANSLATE_NOOP("Actions", "Show everything, direction kept"), false},
      {"view.isometric", QT_TRANSLATE_NOOP("Actions", "&Isometric"), "Ctrl+1",
       QT_TRANSLATE_NOOP("Actions", "Look from a corner"), false},
      {"view.front", QT_TRANSLATE_NOOP("Actions", "Fr&ont"), "Ctrl+2", QT_TRANSLATE_NOOP("Actions", "Look along y"),
       false},
      {"view.back", QT_TRANSLATE_NOOP("Actions", "&Back"), "Ctrl+3", QT_TRANSLATE_NOOP("Actions", "Look against y"),
       false},
      {"view.left", QT_TRANSLATE_NOOP("Actions", "&Left"), "Ctrl+4", QT_TRANSLATE_NOOP("Actions", "Look along x"),
       false},
      {"view.right", QT_TRANSLATE_NOOP("Actions", "&Right"), "Ctrl+5", QT_TRANSLATE_NOOP("Actions", "Look against x"),
       false},
      {"view.top", QT_TRANSLATE_NOOP("Actions", "&Top"), "Ctrl+6", QT_TRANSLATE_NOOP("Actions", "Look down"), false},
      {"view.bottom", QT_TRANSLATE_NOOP("Actions", "Botto&m"), "Ctrl+7", QT_TRANSLATE_NOOP("Actions", "Look up"),
       false},
      {"view.dark", QT_TRANSLATE_NOOP("Actions", "&Dark theme"), "Ctrl+D",
       QT_TRANSLATE_NOOP("Actions", "Light figures on a dark ground"), true},
      {"layer.bodies", QT_TRANSLATE_NOOP("Actions", "Obstacles"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the obstacles"), true},
      {"layer.object", QT_TRANSLATE_NOOP("Actions", "Object"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the object in your hand"), true},
      {"layer.ends", QT_TRANSLATE_NOOP("Actions", "Start and goal"), "",
       QT_TRANSLATE_NOOP("Actions", "Show start and goal as ghosts"), true},
      {"layer.workspace", QT_TRANSLATE_NOOP("Actions", "Workspace"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the bounds of the reference point"), true},
      {"layer.roadmap", QT_TRANSLATE_NOOP("Actions", "Roadmap"), "", QT_TRANSLATE_NOOP("Actions", "Show the trees"),
       true},
      {"layer.path", QT_TRANSLATE_NOOP("Actions", "Path"), "", QT_TRANSLATE_NOOP("Actions", "Show the path"), true},
      {"layer.contact", QT_TRANSLATE_NOOP("Actions", "Contact"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the nearest obstacle and the tangent plane"), true},
      {"help.shortcuts", QT_TRANSLATE_NOOP("Actions", "&Keys and shortcuts"), "F1",
       QT_TRANSLATE_NOOP("Actions", "How to steer, and all shortcuts"), false},
      {"help.about", QT_TRANSLATE_NOOP("Actions", "&About Glissade"), "",
       QT_TRANSLATE_NOOP("Actions", "Version, licence and the papers"), false},
  };
  return specs;
}

ActionCatalogue::ActionCatalogue(QObject* parent) : QObject(parent) {
  for (const ActionSpec& spec : actionSpecs()) {
    auto* action = new QAction(translated(spec.text), this);
    action->setObjectName(QLatin1String(spec.id));
    action->setCheckable(spec.checkable);
    const QKeySequence keys(QString::fromLatin1(spec.shortcut));
    action->setShortcut(keys);
    QString tip = translated(spec.tip);
    if (!keys.isEmpty()) tip += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
    action->setToolTip(tip);
    action->setStatusTip(translated(spec.tip));
    actions_.insert(QLatin1String(spec.id), action);
  }
}

QString ActionCatalogue::shortcutTable() const {
  QString rows;
  for (const ActionSpec& spec : actionSpecs()) {
    if (spec.shortcut[0] == '\0') continue;
    const QAction* action = actions_.value(QLatin1String(spec.id));
    rows +=
        QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td><td>&nbsp;&nbsp;%3</td></tr>")
            .arg(action->shortcut().toString(QKeySequence::NativeText), plain(action->text()), translated(spec.tip));
  }
  return rows;
}

}  // namespace glissade
