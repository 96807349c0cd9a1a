#pragma once

#include <QAction>
#include <QString>

namespace glissade {

/// The menus from the menu bar to the action, in the language of the window: "View > Layers". Empty if the menu bar
/// does not contain the action.
QString menuPath(const QAction& action);

}  // namespace glissade
