#include "widgets/view/full_screen.h"

#include <QDockWidget>
#include <QEvent>
#include <QGuiApplication>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QWindow>

namespace glissade {
namespace {

QScreen* screenNamed(const QString& name) {
  for (QScreen* screen : QGuiApplication::screens()) {
    if (screen->name() == name) return screen;
  }
  return nullptr;
}

}  // namespace

FullScreen::FullScreen(QMainWindow& window, const ActionCatalogue& actions)
    : QObject(&window), window_(window), actions_(actions) {
  window.installEventFilter(this);
}

QList<QWidget*> FullScreen::around() const {
  QList<QWidget*> widgets{window_.menuBar(), window_.statusBar()};
  for (QToolBar* bar : window_.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) widgets << bar;
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) widgets << dock;
  return widgets;
}

void FullScreen::enter(const QString& display) {
  if (on_) return;
  on_ = true;
  panels_ = window_.saveState();
  geometry_ = window_.geometry();
  maximized_ = window_.isMaximized();
  // The shortcuts of a command work only if a visible menu or the window itself has the command.
  for (const ActionSpec& spec : actions_.specs()) window_.addAction(actions_[QLatin1String(spec.id)]);
  for (QWidget* widget : around()) {
    if (widget->isHidden()) continue;
    widget->hide();
    hidden_ << widget;
  }
  QScreen* named = screenNamed(display);
  if (named != nullptr && window_.windowHandle() != nullptr) window_.windowHandle()->setScreen(named);
  window_.setGeometry((named != nullptr ? named : window_.screen())->geometry());
  window_.showFullScreen();
}

void FullScreen::leave() {
  if (!on_) return;
  on_ = false;
  if (maximized_) {
    window_.showMaximized();
  } else {
    window_.showNormal();
    window_.setGeometry(geometry_);
  }
  for (const QPointer<QWidget>& widget : hidden_) {
    if (widget) widget->show();
  }
  hidden_.clear();
  for (const ActionSpec& spec : actions_.specs()) window_.removeAction(actions_[QLatin1String(spec.id)]);
  window_.restoreState(panels_);
  emit left();
}

/// Leaves full screen before the window closes, so that its layout before is remembered.
bool FullScreen::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Close) leave();
  return QObject::eventFilter(watched, event);
}

}  // namespace glissade
