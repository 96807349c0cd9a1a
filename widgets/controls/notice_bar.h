#pragma once

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// A message, and the actions that a person can take.
struct Notice {
  QString title;                     ///< one sentence
  QString details;                   ///< the facts, plain text; may have lines
  std::vector<const char*> actions;  ///< ids of the catalogue, as buttons
};

/// Pixels beside a bar at the top of the scene that leave room for the view cube.
inline constexpr int kRoomForViewCube = 104;

/// A bar over the scene with a refusal, its reason, and buttons for possible actions. Its buttons are reached by Tab.
class NoticeBar final : public QFrame {
  Q_OBJECT

 public:
  /// The bar stays at the top of `scene`; hidden until there is a notice. `rightMargin` pixels are left free.
  NoticeBar(const ActionCatalogue& actions, QWidget* scene, int rightMargin);

  void showNotice(const Notice& notice);
  const Notice& notice() const { return notice_; }

 signals:
  void closed();
  /// The notice has changed, or the bar was shown or hidden.
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void makeButtons();
  void fitWidth();
  int buttonsWidth() const;

  const ActionCatalogue& actions_;
  int rightMargin_;
  Notice notice_;
  QLabel* title_;
  QLabel* details_;
  QBoxLayout* buttons_;
};

}  // namespace glissade
