#include "widgets/controls/menu_path.h"

#include <QMenu>
#include <QMenuBar>

#include <algorithm>

#include "widgets/controls/action_catalogue.h"

namespace glissade {
namespace {

bool isInMenuBar(const QAction& action) {
  const QList<QWidget*> widgets = action.associatedWidgets();
  return std::any_of(widgets.begin(), widgets.end(),
                     [](const QWidget* widget) { return qobject_cast<const QMenuBar*>(widget) != nullptr; });
}

}  // namespace

/// Ignores context menus and menus of buttons, which belong to no menu bar.
QString menuPath(const QAction& action) {
  for (const QWidget* widget : action.associatedWidgets()) {
    const auto* menu = qobject_cast<const QMenu*>(widget);
    if (menu == nullptr) continue;
    const QString title = commandName(menu->title());
    if (isInMenuBar(*menu->menuAction())) return title;
    const QString above = menuPath(*menu->menuAction());
    if (!above.isEmpty()) return above + QStringLiteral(" > ") + title;
  }
  return {};
}

}  // namespace glissade
