#include "app/window/menus.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <utility>

#include "app/window/menu_table.h"
#include "widgets/controls/menu_mnemonics.h"
#include "widgets/workbench/panel_docks.h"

namespace glissade {
namespace {

constexpr const char* kDisplayModes[] = {"display.shaded-edges", "display.shaded", "display.see-through",
                                         "display.wireframe", "display.depth-shading"};

/// A button of the tool bar; "" for a separator.
struct ToolButton {
  const char* action;
  bool hasText = false;   ///< false: the icon needs no text, which would push other buttons off small screens
  const char* menu = "";  ///< menu of further actions at its side
};

constexpr ToolButton kToolButtons[] = {
    {"file.open", true},
    {"file.save"},
    {""},
    {"edit.undo"},
    {"edit.redo"},
    {""},
    {"sequence.plan", true},
    {"run.start", true},
    {"run.stop", true},
    {""},
    {"sequence.instruction", true},
    {"measure.distance", false, "menu.measure"},
    {"section.add-x", false, "menu.section"},
    {""},
    {"view.fit"},
};

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
    std::vector<Entry> entries;
    for (const MenuSpec& spec : menuTable()) {
      const QString id = QLatin1String(spec.id);
      if (spec.title != nullptr) {
        menus.insert(id, new QMenu(tr(spec.title), &window_));
        menus[id]->setObjectName(id);
      }
      entries.push_back({spec.place, menus[id]->menuAction()});
    }
    for (const ActionSpec& spec : actions_.specs()) entries.push_back({spec.place, actions_[QLatin1String(spec.id)]});
    fill(std::move(entries), menus);
    addPanels(*menus[QStringLiteral("menu.panels")]);
  }

  void makeToolBar() {
    auto* bar = new ToolBar(tr("Tools"), &window_);
    window_.addToolBar(bar);
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    std::vector<QToolButton*> worded;
    for (const ToolButton& tool : kToolButtons) {
      if (tool.action[0] == '\0') {
        bar->addSeparator();
        continue;
      }
      QAction* action = actions_[QLatin1String(tool.action)];
      bar->addAction(action);
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
      if (tool.menu[0] != '\0') {
        button->setMenu(window_.findChild<QMenu*>(QLatin1String(tool.menu)));
        button->setPopupMode(QToolButton::MenuButtonPopup);
      }
      if (tool.hasText) {
        worded.push_back(button);
      } else {
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
      }
    }
    bar->setWorded(std::move(worded));
    addDisplayButton(*bar);
  }

 private:
  /// An action or the title of a menu, with its place.
  struct Entry {
    MenuPlace place;
    QAction* action;
  };

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

  /// Adds each entry to its menu, or to the menu bar, in the order of their places.
  void fill(std::vector<Entry> entries, const QHash<QString, QMenu*>& menus) {
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return std::pair(a.place.group, a.place.order) < std::pair(b.place.group, b.place.order);
    });
    QHash<QMenu*, int> groups;
    for (const auto& [place, action] : entries) {
      const bool isTitle = place.menu[0] == '\0' && action->menu() != nullptr;
      if (isTitle) window_.menuBar()->addAction(action);
      QMenu* menu = menus.value(QLatin1String(place.menu));
      if (menu == nullptr) continue;
      if (groups.contains(menu) && groups[menu] != place.group) menu->addSeparator();
      groups[menu] = place.group;
      menu->addAction(action);
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
