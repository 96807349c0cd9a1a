#include "app/window/menus.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/window/menu_table.h"
#include "widgets/controls/menu_mnemonics.h"
#include "widgets/workbench/panel_docks.h"

namespace glissade {
namespace {

constexpr const char* kDisplayModes[] = {"display.shaded-edges", "display.shaded", "display.see-through",
                                         "display.wireframe", "display.depth-shading"};

/// A tool bar that hides the words of its buttons if it is too narrow for them.
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

  void makeMenuBar(const std::vector<QMenu*>& filledMenus) {
    QHash<QString, QMenu*> menus;
    for (QMenu* menu : filledMenus) menus.insert(menu->objectName(), menu);
    for (const MenuSpec& spec : menuTable()) {
      auto* menu = new QMenu(tr(spec.title), &window_);
      menu->setObjectName(QLatin1String(spec.id));
      menus.insert(menu->objectName(), menu);
    }
    for (const MenuSpec& spec : menuTable()) fill(*menus[QLatin1String(spec.id)], spec.entries, menus);
    addPanels(*menus[QStringLiteral("menu.panels")]);
    for (const char* id : menuBarTable()) window_.menuBar()->addMenu(menus[QLatin1String(id)]);
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
  /// Adds one button for the display modes: it shows the present mode, and its menu lists all modes.
  void addDisplayButton(QToolBar& bar) {
    auto* button = new QToolButton(&bar);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setAccessibleName(withoutMnemonic(tr("&Display")));
    auto* menu = new QMenu(tr("&Display"), button);
    for (const char* id : kDisplayModes) menu->addAction(actions_[QLatin1String(id)]);
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

  void fill(QMenu& menu, const std::vector<const char*>& entries, const QHash<QString, QMenu*>& menus) {
    for (const char* entry : entries) {
      const QLatin1String id(entry);
      if (id.isEmpty()) {
        menu.addSeparator();
      } else if (QMenu* submenu = menus.value(id)) {
        menu.addMenu(submenu);
      } else {
        menu.addAction(actions_[id]);
      }
    }
  }

  /// Inserts a check mark for each panel above the entries of the table.
  void addPanels(QMenu& menu) {
    QAction* below = menu.insertSeparator(menu.actions().value(0));
    for (const QDockWidget* dock : docksInOrder(window_)) {
      QAction* toggle = dock->toggleViewAction();
      toggle->setStatusTip(tr("Show or hide the panel"));
      menu.insertAction(below, toggle);
    }
    addMnemonics(menu);
  }

  QMainWindow& window_;
  const ActionCatalogue& actions_;
};

}  // namespace

void makeMenus(QMainWindow& window, const ActionCatalogue& actions, const std::vector<QMenu*>& filledMenus) {
  Menus menus(window, actions);
  menus.makeMenuBar(filledMenus);
  menus.makeToolBar();
}

}  // namespace glissade
