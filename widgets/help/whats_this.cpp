#include "widgets/help/whats_this.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>
#include <QTreeWidget>

#include <vector>

namespace glissade {
namespace {

struct PartHelp {
  const char* name;  ///< object name of the widget
  const char* text;  ///< English; translated in the context "WhatsThis"
};

struct ColumnHelp {
  const char* table;
  std::vector<const char*> texts;  ///< texts of the first columns
};

QString helpText(const char* text) { return QCoreApplication::translate("WhatsThis", text); }

const std::vector<PartHelp>& panelHelp() {
  static const std::vector<PartHelp> panels{
      {"interaction",
       QT_TRANSLATE_NOOP("WhatsThis",
                         "The settings of the next run. The strategy is the planner. The operator holds the object: "
                         "you, a device, or a simulated person. The sliders can be moved during a run.")},
      {"product", QT_TRANSLATE_NOOP("WhatsThis", "The product: its bodies, and the places of the free space.")},
      {"contacts", QT_TRANSLATE_NOOP("WhatsThis", "How the bodies of the product touch, and how they are joined.")},
      {"scene-tree",
       QT_TRANSLATE_NOOP("WhatsThis",
                         "All bodies of the scenario: the moving part with its start and goal, and the obstacles. A "
                         "checked box draws a body. Below are position and angles of what is selected.")},
      {"semantics",
       QT_TRANSLATE_NOOP("WhatsThis",
                         "What is known of places and bodies. Above are the places with their complexity and width, "
                         "below the attributes of what is selected. The coarse path follows each change at once.")},
      {"fits",
       QT_TRANSLATE_NOOP("WhatsThis",
                         "The pairs of bodies that touch or overlap as designed, with their kind and the allowance "
                         "that planning takes. The menu of a row accepts a clash or marks a thread.")},
      {"joints",
       QT_TRANSLATE_NOOP("WhatsThis",
                         "How the bodies are joined: screws, nuts, inserts, pins, units. The menu of a row confirms or "
                         "dissolves joints. Assembly plans keep to them.")},
      {"section", QT_TRANSLATE_NOOP(
                      "WhatsThis",
                      "Planes that cut bodies open in the view: across an axis, or along a face. Arrows in the scene "
                      "drag them. Planning ignores them.")},
      {"run", QT_TRANSLATE_NOOP("WhatsThis",
                                "Figures of the run: iterations, nodes and edges of the two trees, configurations by "
                                "who drew them, and the nearest obstacle of the object.")},
      {"plan", QT_TRANSLATE_NOOP("WhatsThis",
                                 "The steps of the coarse path through places, with the planner of each and its "
                                 "result. A click on a row shows its place in the scene.")},
      {"path", QT_TRANSLATE_NOOP("WhatsThis",
                                 "The path that was found, its certificate and its clearance. The slider and the curve "
                                 "move the object along it.")},
      {"paths", QT_TRANSLATE_NOOP("WhatsThis",
                                  "The paths that the scenario keeps. Each is certified again when the scenario is "
                                  "opened or arranged. A checked box draws a path in the scene.")},
      {"log", QT_TRANSLATE_NOOP("WhatsThis", "All messages since the program was started.")},
      {"sequence",
       QT_TRANSLATE_NOOP("WhatsThis",
                         "In which order the parts of the product are removed, each with a certified motion. A click "
                         "on a row shows the step. Rows can be dragged, locked and moved by hand.")},
      {"difficulty", QT_TRANSLATE_NOOP("WhatsThis",
                                       "Why no path was found: where the trees come nearest, which body "
                                       "stands between them, and how much is missing.")},
      {"tools", QT_TRANSLATE_NOOP("WhatsThis", "Files, undo, the run, and views of the scene.")},
      {"replay", QT_TRANSLATE_NOOP("WhatsThis", "The recorded run that is replayed, step by step.")},
      {"scene",
       QT_TRANSLATE_NOOP(
           "WhatsThis",
           "The scene. Drag to orbit, middle-drag to pan, wheel to zoom, double-click to fit. A "
           "click selects a body, or a place while places are shown; Ctrl+Shift and a drag select all bodies in a "
           "box. The right button opens a "
           "menu. Keys move the object (Ctrl+F1 lists them).")},
      {"welcome", QT_TRANSLATE_NOOP("WhatsThis", "What can be opened: new parts, recent files and samples.")},
  };
  return panels;
}

const std::vector<ColumnHelp>& columnHelp() {
  static const std::vector<ColumnHelp> tables{
      {"bodies",
       {QT_TRANSLATE_NOOP("WhatsThis", "The name of the body. A checked box draws it."),
        QT_TRANSLATE_NOOP("WhatsThis",
                          "Moving part, static body, or mobile body. A static body keeps its place; a person can move "
                          "a mobile one out of the way."),
        QT_TRANSLATE_NOOP("WhatsThis", "How many triangles its surface has.")}},
      {"semantics-tree",
       {QT_TRANSLATE_NOOP("WhatsThis", "A place or a body. F2 renames a place."),
        QT_TRANSLATE_NOOP("WhatsThis", "How hard the place is to pass, from its width and from what clutters it."),
        QT_TRANSLATE_NOOP("WhatsThis", "How wide the place is at its narrowest.")}},
      {"attributes",
       {QT_TRANSLATE_NOOP("WhatsThis", "The name of the attribute. Your own can be renamed and removed."),
        QT_TRANSLATE_NOOP("WhatsThis", "Its value for what is selected."),
        QT_TRANSLATE_NOOP("WhatsThis",
                          "Where the value comes from: computed from geometry, a class of bodies, or you."),
        QT_TRANSLATE_NOOP("WhatsThis", "Removes your value.")}},
      {"fits-table",
       {QT_TRANSLATE_NOOP("WhatsThis", "How they meet: planar, cylindrical, thread, press, overlap, contact or clash."),
        QT_TRANSLATE_NOOP("WhatsThis", "The distance of the surfaces; negative where the bodies overlap."),
        QT_TRANSLATE_NOOP("WhatsThis", "The first body of the pair."),
        QT_TRANSLATE_NOOP("WhatsThis", "The second body of the pair."),
        QT_TRANSLATE_NOOP("WhatsThis", "By how much the object is thinner against the other body."),
        QT_TRANSLATE_NOOP("WhatsThis", "What was decided about the pair.")}},
      {"joints-table",
       {QT_TRANSLATE_NOOP("WhatsThis",
                          "How they are joined: screw, nut, thread, insert, pin, snap, flexible, permanent, unit."),
        QT_TRANSLATE_NOOP("WhatsThis", "The body that is removed: the screw, the nut, the insert, the pin."),
        QT_TRANSLATE_NOOP("WhatsThis", "What it is joined with, and what it clamps."),
        QT_TRANSLATE_NOOP("WhatsThis", "The designation or the size of the thread, and the turns until it is free."),
        QT_TRANSLATE_NOOP("WhatsThis",
                          "Recognised by shape, suggested by name or class, or user-defined. A (?) marks doubt.")}},
      {"steps",
       {QT_TRANSLATE_NOOP("WhatsThis", "The place that the step crosses."),
        QT_TRANSLATE_NOOP("WhatsThis", "The place that it leads to."),
        QT_TRANSLATE_NOOP("WhatsThis", "The planner that searches the step."),
        QT_TRANSLATE_NOOP("WhatsThis", "Random configurations that were drawn for the step."),
        QT_TRANSLATE_NOOP("WhatsThis", "The result of the step.")}},
      {"kept-paths",
       {QT_TRANSLATE_NOOP("WhatsThis", "The name of the path. A checked box draws it."),
        QT_TRANSLATE_NOOP("WhatsThis", "Whether the path is certified in the present arrangement."),
        QT_TRANSLATE_NOOP("WhatsThis", "The smallest distance to other bodies along the path."),
        QT_TRANSLATE_NOOP("WhatsThis", "The length of the path of the reference point."),
        QT_TRANSLATE_NOOP("WhatsThis", "By how much the object turns along the path."),
        QT_TRANSLATE_NOOP("WhatsThis", "The strategy that found it."),
        QT_TRANSLATE_NOOP("WhatsThis", "The seed of that run: the same seed gives the same path."),
        QT_TRANSLATE_NOOP("WhatsThis", "The largest allowance that the path needs.")}},
      {"sequence",
       {QT_TRANSLATE_NOOP("WhatsThis", "The number of the step."),
        QT_TRANSLATE_NOOP("WhatsThis", "The part that is removed or assembled, and the kind of its motion."),
        QT_TRANSLATE_NOOP("WhatsThis", "The smallest distance to other parts, and the largest allowance."),
        QT_TRANSLATE_NOOP("WhatsThis", "The tool that turns a fastener, and which parts need support."),
        QT_TRANSLATE_NOOP("WhatsThis",
                          "Whether the independent check agrees, and which constraints the step violates.")}},
      {"difficulty-rows",
       {QT_TRANSLATE_NOOP("WhatsThis", "The place that was examined."),
        QT_TRANSLATE_NOOP("WhatsThis", "The distance or the overlap there."),
        QT_TRANSLATE_NOOP("WhatsThis", "The body that is nearest there.")}},
      {"log-messages",
       {QT_TRANSLATE_NOOP("WhatsThis", "When the message came."),
        QT_TRANSLATE_NOOP("WhatsThis", "Information, warning or error."),
        QT_TRANSLATE_NOOP("WhatsThis", "What happened.")}},
  };
  return tables;
}

bool isInteractive(const QWidget& widget) {
  return widget.focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton*>(&widget) != nullptr;
}

}  // namespace

void explainWindow(QMainWindow& window) {
  for (const PartHelp& help : panelHelp()) {
    for (QWidget* widget : window.findChildren<QWidget*>(QLatin1String(help.name))) {
      // A table and its panel may have the same name.
      if (qobject_cast<QTreeWidget*>(widget) == nullptr) widget->setWhatsThis(helpText(help.text));
    }
  }
  for (const ColumnHelp& help : columnHelp()) {
    auto* table = window.findChild<QTreeWidget*>(QLatin1String(help.table));
    int column = 0;
    for (const char* text : help.texts) table->headerItem()->setData(column++, Qt::WhatsThisRole, helpText(text));
  }
  const QString tabs = helpText(QT_TRANSLATE_NOOP("WhatsThis",
                                                  "Panels that share a place. Alt and a digit bring one to "
                                                  "the front; View > Panels shows and hides them."));
  for (QTabBar* bar : window.findChildren<QTabBar*>()) bar->setWhatsThis(tabs);
  window.menuBar()->setWhatsThis(
      helpText(QT_TRANSLATE_NOOP("WhatsThis", "All commands. Ctrl+K finds one by a part of its name.")));
  window.statusBar()->setWhatsThis(
      helpText(QT_TRANSLATE_NOOP("WhatsThis", "What the program is doing, what keys and devices move, and devices.")));
}

QStringList unexplainedWidgets(const QMainWindow& window) {
  QStringList names;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!isInteractive(*widget) || widget->window() != &window) continue;
    const QWidget* explained = widget;
    while (explained != nullptr && explained->whatsThis().isEmpty()) explained = explained->parentWidget();
    if (explained == nullptr) {
      names << QStringLiteral("%1 %2").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
    }
  }
  return names;
}

}  // namespace glissade
