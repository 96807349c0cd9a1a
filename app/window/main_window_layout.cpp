// Where panels lie, and what the menus and the tool bar hold.
#include <QDockWidget>
#include <QMenuBar>
#include <QScrollArea>
#include <QStyle>
#include <QToolBar>
#include <QToolButton>

#include "app/window/assembly_controller.h"
#include "app/window/body_visibility.h"
#include "app/window/difficulty_controller.h"
#include "app/window/environment_controller.h"
#include "app/window/main_window.h"
#include "app/window/path_controller.h"
#include "widgets/panels/counts_panel.h"
#include "widgets/panels/interaction_panel.h"

namespace glissade {
void MainWindow::addPanel(const QString& title, const char* id, QWidget* content, const char* action,
                          Scrolling scrolling) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(QLatin1String(id));
  if (action[0] != '\0') {
    connect((*actions_)[QLatin1String(action)], &QAction::triggered, dock, [dock, content] {
      dock->show();
      dock->raise();
      if (content->focusProxy() != nullptr) content->setFocus(Qt::ShortcutFocusReason);
    });
  }
  if (scrolling == Scrolling::Own) {
    dock->setWidget(content);
    return;
  }
  auto* scroll = new QScrollArea(dock);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 2 * bar);
  dock->setWidget(scroll);
}

void MainWindow::makePanels() {
  interaction_ = new InteractionPanel(*actions_, this);
  counts_ = new CountsPanel(this);
  bodies_ = new BodyVisibility(*actions_, *scene_, *assembly_->scenePanel(), environment_->document(), this);
  addPanel(tr("Interaction"), "interaction", interaction_);
  addPanel(tr("Scene"), "scene-tree", assembly_->panel(), "panel.scene");
  addPanel(tr("Run"), "run", counts_, "panel.run");
  addPanel(tr("Path"), "path", path_->panel(), "panel.path");
  addPanel(tr("Semantics"), "semantics", environment_->semanticsPanel(), "panel.semantics", Scrolling::Own);
  addPanel(tr("Plan"), "plan", environment_->planPanel(), "panel.plan", Scrolling::Own);
  addPanel(tr("Difficulty"), "difficulty", difficulty_->panel(), "panel.difficulty", Scrolling::Own);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  arrangePanels();
}

/// As the window is at first.
void MainWindow::arrangePanels() {
  const auto dock = [this](const char* id) { return findChild<QDockWidget*>(QLatin1String(id)); };
  for (QDockWidget* each : findChildren<QDockWidget*>()) removeDockWidget(each);
  addDockWidget(Qt::LeftDockWidgetArea, dock("interaction"));
  addDockWidget(Qt::RightDockWidgetArea, dock("scene-tree"));
  addDockWidget(Qt::RightDockWidgetArea, dock("run"));
  // What is looked at by turns shares a place: small screens have no room for six panels, not even for a moment.
  tabifyDockWidget(dock("scene-tree"), dock("semantics"));
  tabifyDockWidget(dock("run"), dock("plan"));
  tabifyDockWidget(dock("plan"), dock("path"));
  tabifyDockWidget(dock("path"), dock("difficulty"));
  for (QDockWidget* each : findChildren<QDockWidget*>()) {
    each->setFloating(false);
    each->show();
  }
  for (QToolBar* tools : findChildren<QToolBar*>(QStringLiteral("tools"))) tools->show();
  dock("difficulty")->setVisible(difficulty_->difficulty() != nullptr);
  (*actions_)["panel.scene"]->trigger();
  (*actions_)["panel.run"]->trigger();
  resizeDocks({dock("interaction"), dock("scene-tree")}, {270, 340}, Qt::Horizontal);
  resizeDocks({dock("scene-tree"), dock("run")}, {330, 300}, Qt::Vertical);
}

void MainWindow::makeMenus() {
  const auto fill = [this](QMenu* menu, const char* prefix) {
    for (const ActionSpec& spec : actionSpecs()) {
      if (QLatin1String(spec.id).startsWith(QLatin1String(prefix)))
        menu->addAction((*actions_)[QLatin1String(spec.id)]);
    }
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  fill(file, "file.");
  recent_ = new QMenu(tr("Open re&cent"), this);
  file->insertMenu((*actions_)["file.save"], recent_);
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  fill(edit, "edit.");
  edit->addSeparator();
  fill(edit, "environment.");
  fill(edit, "place.");
  fill(edit, "milestone.");
  edit->addSeparator();
  fill(edit, "attribute.");
  fill(menuBar()->addMenu(tr("&Assembly")), "assembly.");
  QMenu* run = menuBar()->addMenu(tr("&Run"));
  fill(run, "run.");
  fill(run, "work.");
  fill(run, "strategy.");
  run->addSeparator();
  fill(run, "replay.");
  run->addSeparator();
  fill(run, "object.");
  fill(run, "path.");
  fill(run, "difficulty.");
  fill(menuBar()->addMenu(tr("&Study")), "study.");
  fill(menuBar()->addMenu(tr("&Operator")), "operator.");
  QMenu* view = menuBar()->addMenu(tr("&View"));
  fill(view, "view.");
  view->addSeparator();
  fill(view, "body.");
  fill(view->addMenu(tr("Lay&ers")), "layer.");
  QMenu* panels = view->addMenu(tr("&Panels"));
  fill(panels, "panel.");
  panels->addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) panels->addAction(dock->toggleViewAction());
  fill(menuBar()->addMenu(tr("&Help")), "help.");

  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  for (const char* id :
       {"file.open", "file.save", "file.export", "", "edit.undo", "edit.redo", "", "run.start", "run.pause", "run.stop",
        "run.restart-new-seed", "", "view.fit", "view.isometric", "view.front", "view.left", "view.top"}) {
    if (id[0] == '\0') {
      bar->addSeparator();
    } else {
      bar->addAction((*actions_)[QLatin1String(id)]);
    }
  }
  // Cubes and arrows speak for themselves; words there would push other buttons off small screens.
  for (const char* id :
       {"edit.undo", "edit.redo", "view.fit", "view.isometric", "view.front", "view.left", "view.top"}) {
    auto* button = qobject_cast<QToolButton*>(bar->widgetForAction((*actions_)[QLatin1String(id)]));
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
}

}  // namespace glissade
