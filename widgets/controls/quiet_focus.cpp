#include "widgets/controls/quiet_focus.h"

#include <QFocusEvent>

namespace glissade {
namespace {

class QuietFocus final : public QObject {
 public:
  explicit QuietFocus(QAbstractItemView& view) : QObject(&view), view_(view) {}

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::FocusIn || view_.currentIndex().isValid()) return QObject::eventFilter(watched, event);
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    return reason == Qt::ActiveWindowFocusReason || reason == Qt::PopupFocusReason;
  }

 private:
  QAbstractItemView& view_;
};

}  // namespace

void keepUnchosen(QAbstractItemView& view) { view.installEventFilter(new QuietFocus(view)); }

}  // namespace glissade
