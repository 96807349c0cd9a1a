#include "app/window/menus.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace glissade {
namespace {

/// A tool bar whose buttons lose their words where the window is too narrow for them.
class ToolBar : public QToolBar {
 public:
  using QToolBar::QToolBar;
  void setWorded(std::vector<QToolButton*> buttons) { worded_ = std::move(buttons); }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QToolBar::resizeEvent(event);
    if (hasWords_) widthOfWords_ = sizeHint().width();
    const bool isRoomy = width() >= widthOfWords_;
    if (isRoomy == hasWords_) return;
    hasWords_ = isRoomy;
    for (QToolButton* button : worded_) {
      button->setToolButtonStyle(isRoomy ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    }
  }

 private:
  std::vector<QToolButton*> worded_;
  bool hasWords_ = true;
  int widthOfWords_ = 0;
};

class Menus {
  Q_DECLARE_TR_FUNCTIONS(Menus)

 public:
  Menus(QMainWindow& window, const ActionCatalogue& actions) : window_(window), actions_(actions) {}

  void makeMenuBar(const std::vector<QMenu*>& fileMenus, QMenu* namedViews) {
    QMenu* file = add(tr("&File"), {"file."});
    for (QMenu* menu : fileMenus) file->insertMenu(actions_["file.save"], menu);
    add(tr("&Edit"), {"edit.", "", "environment.", "place.", "milestone.", "", "attribute."});
    add(tr("&Assembly"), {"assembly.", "", "fits.", "", "refusal.", "", "sequence."});
    add(tr("&Run"),
        {"run.", "work.", "strategy.", "", "replay.", "", "object.", "path.", "", "paths.", "", "difficulty."});
    add(tr("&Study"), {"study."});
    add(tr("&Operator"), {"operator."});
    QMenu* view = add(tr("&View"), {"view.", "", "body.", "", "measure."});
    fill(view->addMenu(tr("&Display")), {"display.", "", "display-selected."});
    fill(view->addMenu(tr("Secti&on")), {"section."});
    view->addMenu(namedViews);
    fill(view->addMenu(tr("Lay&ers")), {"layer."});
    fill(view->addMenu(tr("&Navigation")), {"navigation."});
    QMenu* panels = view->addMenu(tr("&Panels"));
    fill(panels, {"panel.", ""});
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) panels->addAction(dock->toggleViewAction());
    add(tr("&Help"), {"help.", "", "log."});
  }

  void makeToolBar() {
    auto* bar = new ToolBar(tr("Tools"), &window_);
    window_.addToolBar(bar);
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    for (const char* id : {"file.open", "file.save", "file.export", "", "edit.undo", "edit.redo", "", "run.start",
                           "run.pause", "run.stop", "run.restart-new-seed", "", "view.fit", "view.isometric",
                           "view.front", "view.left", "view.top"}) {
      if (id[0] == '\0') {
        bar->addSeparator();
      } else {
        bar->addAction(actions_[QLatin1String(id)]);
      }
    }
    // These icons need no words, which would push other buttons off small screens.
    for (const char* id :
         {"edit.undo", "edit.redo", "view.fit", "view.isometric", "view.front", "view.left", "view.top"}) {
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(actions_[QLatin1String(id)]));
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    }
    std::vector<QToolButton*> worded;
    for (const char* id :
         {"file.open", "file.save", "file.export", "run.start", "run.pause", "run.stop", "run.restart-new-seed"}) {
      worded.push_back(qobject_cast<QToolButton*>(bar->widgetForAction(actions_[QLatin1String(id)])));
    }
    bar->setWorded(std::move(worded));
    bar->addSeparator();
    addDisplayButton(*bar);
  }

 private:
  /// One button for the display modes: it shows the present one, and its menu has all.
  void addDisplayButton(QToolBar& bar) {
    auto* button = new QToolButton(&bar);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setAccessibleName(withoutMnemonic(tr("&Display")));
    auto* menu = new QMenu(tr("&Display"), button);
    fill(menu, {"display."});
    button->setMenu(menu);
    for (QAction* action : menu->actions()) {
      // The icon changes with the mode and with the theme.
      const auto show = [button, action] {
        const bool isMode = action->actionGroup() != nullptr;
        if (!isMode || !action->isChecked()) return;
        button->setIcon(action->icon());
        button->setToolTip(action->toolTip());
      };
      QObject::connect(action, &QAction::changed, button, show);
      show();
    }
    bar.addWidget(button);
  }

  /// `prefixes` of action ids; an empty one is a separator.
  QMenu* add(const QString& title, std::initializer_list<const char*> prefixes) {
    QMenu* menu = window_.menuBar()->addMenu(title);
    fill(menu, prefixes);
    return menu;
  }

  void fill(QMenu* menu, std::initializer_list<const char*> prefixes) {
    for (const char* prefix : prefixes) {
      if (prefix[0] == '\0') {
        menu->addSeparator();
        continue;
      }
      for (const ActionSpec& spec : actionSpecs()) {
        const QLatin1String id(spec.id);
        if (id.startsWith(QLatin1String(prefix))) menu->addAction(actions_[id]);
      }
    }
  }

  QMainWindow& window_;
  const ActionCatalogue& actions_;
};

}  // namespace

void makeMenus(QMainWindow& window, const ActionCatalogue& actions, const std::vector<QMenu*>& fileMenus,
               QMenu* namedViews) {
  Menus menus(window, actions);
  menus.makeMenuBar(fileMenus, namedViews);
  menus.makeToolBar();
}

}  // namespace glissade
