#pragma once

#include <QMenu>

#include "widgets/workbench/named_views.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class WindowMemory;

/// The named views of the open scenario: its menu, its actions, its script commands. The window remembers them by the
/// scenario's file name. The file does not contain them, because a product does not include how people look at it.
class NamedViewsController final : public QObject {
  Q_OBJECT

 public:
  explicit NamedViewsController(const Workbench& bench);

  QMenu* menu() const { return menu_; }
  /// Sets the memory that keeps views between sessions; null: none.
  void setMemory(WindowMemory* memory);

 signals:
  void cameraMoved();
  void viewsChanged(const glissade::NamedViews& views);

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
  std::string file_;         ///< the scenario file of the views; empty: none
  QList<QAction*> entries_;  ///< one entry for each view
};

}  // namespace glissade
