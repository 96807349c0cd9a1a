#pragma once

#include <QMenu>

#include "app/window/named_views.h"
#include "app/window/workbench.h"

namespace glissade {

class WindowMemory;

/// The named views of the scenario that is open: its menu, its actions, its script commands. They belong to the user,
/// not to the scenario file, because how a product is looked at is no part of it; the window remembers them by file.
class NamedViewsController final : public QObject {
  Q_OBJECT

 public:
  explicit NamedViewsController(const Workbench& bench);

  QMenu* menu() const { return menu_; }
  /// Where views are kept from one start to the next; null: nowhere.
  void setMemory(WindowMemory* memory);

 signals:
  void cameraMoved();

 private:
  void load();
  void setViews(NamedViews views);
  void fillMenu();
  void save(const QString& name);
  void goTo(const NamedView& view);
  QString freeName() const;
  void askForName();
  void manage();
  void addCommands();

  const Workbench& bench_;
  QMenu* menu_;
  WindowMemory* memory_ = nullptr;
  NamedViews views_;
  std::string file_;         ///< that the views are kept for; empty: none
  QList<QAction*> entries_;  ///< one for each view
};

}  // namespace glissade
