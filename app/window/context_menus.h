#pragma once

#include <QMenu>
#include <QPointer>

#include <optional>

#include "app/window/scene_target.h"

namespace glissade {

/// The context menus of the scene and of tables, made of actions of the catalogue. In the scene, the right button opens
/// the menu of what is under the pointer where it is pressed and released at one place: a drag moves the camera in some
/// navigation styles. The menu key and Shift+F10 open the menu of what is selected.
class ContextMenus final : public QObject {
  Q_OBJECT

 public:
  /// To be made when the panels are there.
  explicit ContextMenus(const Workbench& bench);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addTableMenus();
  /// As the menu key does, in the widget that has the focus.
  void openByKeyboard();
  bool handleMouse(const QMouseEvent& event);
  /// The target becomes what is selected, where it is not selected yet.
  void select(const SceneTarget& target);
  void open(bool isObject, const QPoint& position);
  void addCommands();

  const Workbench& bench_;
  std::optional<QPointF> pressed_;  ///< where the right button is held without a drag
  QPointer<QMenu> menu_;
};

}  // namespace glissade
