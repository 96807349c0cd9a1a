#include "app/window/screen_fit.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMainWindow>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>

#include <algorithm>

namespace glissade {
namespace {

/// Size of a window's frame: title and borders. It is not known before the window is shown.
constexpr QSize kFrame{8, 32};

bool fits(const QSize& size, const QSize& room) {
  return size.width() <= room.width() && size.height() <= room.height();
}

/// Maximum width of a QMessageBox on its screen. A QMessageBox whose buttons need more width cuts them.
int widestMessage(const QWidget& message) {
  constexpr int kSmallScreen = 1024;
  const int screen = message.screen()->availableGeometry().width();
  return screen <= kSmallScreen ? screen : std::min(screen - 480, 1000);
}

void stackButtons(QMessageBox& message, const QSize& room) {
  auto* buttons = message.findChild<QDialogButtonBox*>();
  if (buttons == nullptr) return;
  const QMargins around = message.layout()->contentsMargins();
  if (buttons->sizeHint().width() + around.left() + around.right() <= std::min(room.width(), widestMessage(message)))
    return;
  buttons->setOrientation(Qt::Vertical);
}

/// The row of buttons at the end of a column; null if the column does not end with one.
QDialogButtonBox* buttonsBelow(QLayout& layout) {
  if (layout.count() == 0) return nullptr;
  return qobject_cast<QDialogButtonBox*>(layout.itemAt(layout.count() - 1)->widget());
}

QScrollArea* scrollContent(QWidget& window) {
  QLayout* inside = window.layout();
  QDialogButtonBox* buttons = buttonsBelow(*inside);
  const QMargins around = inside->contentsMargins();
  if (buttons != nullptr) inside->removeWidget(buttons);
  auto* content = new QWidget;
  content->setLayout(inside);
  auto* scroll = new QScrollArea(&window);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setWidget(content);
  auto* column = new QVBoxLayout(&window);
  column->setContentsMargins(0, 0, 0, buttons != nullptr ? around.bottom() : 0);
  column->addWidget(scroll, 1);
  if (buttons == nullptr) return scroll;
  auto* row = new QHBoxLayout;
  row->setContentsMargins(around.left(), 0, around.right(), 0);
  row->addWidget(buttons);
  column->addLayout(row);
  return scroll;
}

int heightAt(int width, QLayout& layout) {
  layout.activate();
  return layout.hasHeightForWidth() ? layout.totalHeightForWidth(width) : layout.totalSizeHint().height();
}

/// Scrolls the texts of a message that is higher than the room. QMessageBox takes the minimum size of its layout, and
/// makes its texts about as narrow as kNarrow.
void scrollTexts(QMessageBox& message, const QSize& room) {
  constexpr int kNarrow = 500;
  if (auto* text = message.findChild<QLabel*>(QStringLiteral("qt_msgbox_label"))) text->setWordWrap(true);
  const int width = std::min(room.width(), widestMessage(message));
  const int narrow = std::min({width, kNarrow, message.screen()->availableGeometry().width() / 2});
  QLayout& texts = *message.layout();
  if (heightAt(narrow, texts) <= room.height()) return;
  QScrollArea& scroll = *scrollContent(message);
  scroll.setFocusPolicy(Qt::StrongFocus);  // keys scroll the texts
  scroll.widget()->setMinimumWidth(1);     // otherwise QMessageBox makes its labels as wide as their texts
  const int beside = message.style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, &scroll);
  const int rest = message.layout()->totalMinimumSize().height() - scroll.minimumSizeHint().height();
  scroll.setMinimumSize(width, std::min(heightAt(width - beside, texts), room.height() - rest));
}

}  // namespace

void fitWindow(QWidget& window, const QSize& room) {
  if (auto* message = qobject_cast<QMessageBox*>(&window)) {
    message->ensurePolished();
    stackButtons(*message, room);
    scrollTexts(*message, room);
    return;
  }
  window.ensurePolished();
  const bool isOwn = qobject_cast<QFileDialog*>(&window) == nullptr && window.layout() != nullptr;
  if (isOwn && !fits(window.minimumSizeHint().expandedTo(window.minimumSize()), room)) {
    window.setMinimumSize(0, 0);
    const QScrollArea& scroll = *scrollContent(window);
    const int bar = scroll.style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, &scroll);
    const int width = scroll.widget()->minimumSizeHint().width() + bar;
    window.resize(window.size().expandedTo({width, 0}));
  }
  if (!fits(window.size(), room)) window.resize(window.size().boundedTo(room));
}

QSize roomOn(const QWidget& window) {
  const QScreen* screen = window.screen();
  return (screen->availableGeometry().size() - kFrame).expandedTo({1, 1});
}

bool ScreenFit::eventFilter(QObject* watched, QEvent* event) {
  auto* window = event->type() == QEvent::Show ? qobject_cast<QWidget*>(watched) : nullptr;
  const bool isFitted = window != nullptr && qobject_cast<QMainWindow*>(window) == nullptr &&
                        (window->windowType() == Qt::Dialog || window->windowType() == Qt::Window);
  if (isFitted) fitWindow(*window, roomOn(*window));
  return QObject::eventFilter(watched, event);
}

}  // namespace glissade
