#pragma once

#include <QMenu>
#include <QPointer>

#include <optional>

#include "widgets/workbench/scene_target.h"

namespace glissade {

/// The context menus of the scene and of tables, made of actions of the catalogue. In the scene, a click of the right
/// button opens the menu of the item under the pointer; a drag of the right button moves the camera in some navigation
/// styles. The menu key and Shift+F10 open the menu of the selection.
class ContextMenus final : public QObject {
  Q_OBJECT

 public:
  /// Precondition: the panels exist.
  explicit ContextMenus(const Workbench& bench);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addTableMenus();
  /// Opens the menu of the widget that has the focus, as the menu key does.
  void openByKeyboard();
  bool handleMouse(const QMouseEvent& event);
  /// Selects the target unless it is selected already.
  void select(const SceneTarget& target);
  void open(bool isObject, const QPoint& position);
  void addCommands();

  const Workbench& bench_;
  std::optional<QPointF> pressed_;  ///< position at which the right button was pressed, until a drag
  QPointer<QMenu> menu_;
};

}  // namespace glissade
