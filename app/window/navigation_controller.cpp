#include "app/window/navigation_controller.h"

#include <QActionGroup>

#include "widgets/scene3d/navigation_style.h"

namespace glissade {

NavigationController::NavigationController(const Workbench& bench) : QObject(&bench.window) {
  auto* group = new QActionGroup(this);
  for (const NavigationStyleEntry& entry : kNavigationStyles) {
    QAction* action = group->addAction(bench.actions[QLatin1String(entry.action)]);
    connect(action, &QAction::toggled, this, [&scene = bench.scene, style = entry.style](bool chosen) {
      if (chosen) scene.setNavigationStyle(style);
    });
  }
  bench.actions[QLatin1String(kNavigationStyles.front().action)]->setChecked(true);
}

}  // namespace glissade
