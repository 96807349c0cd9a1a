#include "widgets/controls/fresh_tips.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QHelpEvent>
#include <QTimer>
#include <QToolTip>

namespace glissade {

FreshTips::FreshTips(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool FreshTips::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ToolTip && watched->isWidgetType()) {
    const QPointer<QWidget> widget = static_cast<QWidget*>(watched);
    const QPoint at = static_cast<QHelpEvent*>(event)->pos();
    QTimer::singleShot(0, this, [this, widget, at] { watch(widget, at); });
  } else if (event->type() == QEvent::Paint && !widget_.isNull() && watched == widget_) {
    QTimer::singleShot(0, this, [this] { hideIfStale(); });
  }
  return QObject::eventFilter(watched, event);
}

void FreshTips::watch(QWidget* widget, const QPoint& at) {
  widget_ = widget;
  at_ = at;
  const bool isOwn = widget != nullptr && QToolTip::isVisible() && tipNow() == QToolTip::text();
  if (!isOwn) widget_.clear();
}

void FreshTips::hideIfStale() {
  if (widget_.isNull()) return;
  const bool isShown = QToolTip::isVisible();
  if (isShown && tipNow() == QToolTip::text()) return;
  widget_.clear();
  if (isShown) QToolTip::hideText();
}

/// The tip of the row of a list, or else of the widget.
QString FreshTips::tipNow() const {
  const auto* view = qobject_cast<const QAbstractItemView*>(widget_->parentWidget());
  const bool isList = view != nullptr && view->viewport() == widget_;
  return isList ? view->indexAt(at_).data(Qt::ToolTipRole).toString() : widget_->toolTip();
}

}  // namespace glissade
