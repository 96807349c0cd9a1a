#include "widgets/controls/notice_bar.h"

#include <QEvent>
#include <QKeyEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kNoticeMargin = 10;
constexpr int kWidestNotice = 640;
constexpr int kNarrowNotice = 320;
constexpr int kButtonGap = 6;

}  // namespace

NoticeBar::NoticeBar(const ActionCatalogue& actions, QWidget* scene, int rightMargin)
    : QFrame(scene),
      actions_(actions),
      rightMargin_(rightMargin),
      title_(new QLabel(this)),
      details_(new QLabel(this)),
      buttons_(new QHBoxLayout) {
  setObjectName(QStringLiteral("notice"));
  setAutoFillBackground(true);
  for (QLabel* label : {title_, details_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setFocusPolicy(Qt::NoFocus);
  }
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setObjectName(QStringLiteral("notice-title"));
  details_->setObjectName(QStringLiteral("notice-details"));
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setFocusPolicy(Qt::TabFocus);
  close->setToolTip(tr("Close this message (Esc)"));
  close->setAccessibleName(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, [this] {
    hide();
    emit closed();
  });
  auto* top = new QHBoxLayout;
  top->addWidget(title_, 1);
  top->addWidget(close, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 10);
  column->setSpacing(4);
  column->addLayout(top);
  column->addWidget(details_);
  column->addLayout(buttons_);
  scene->installEventFilter(this);
  hide();
}

void NoticeBar::showNotice(const Notice& notice) {
  notice_ = notice;
  title_->setText(notice.title);
  details_->setText(notice.details);
  details_->setVisible(!notice.details.isEmpty());
  setAccessibleName(notice.title);
  setAccessibleDescription(notice.details);
  makeButtons();
  show();
  raise();
  fitWidth();
  emit changed();
}

void NoticeBar::makeButtons() {
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    if (QWidget* widget = item->widget()) {
      widget->hide();  // deleted later, because it may be the widget that was clicked
      widget->deleteLater();
    }
    delete item;
  }
  buttons_->setSpacing(kButtonGap);
  for (const char* id : notice_.actions) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(actions_[QLatin1String(id)]);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::TabFocus);
    buttons_->addWidget(button);
    button->show();
  }
  buttons_->addStretch();
}

/// Places the bar beside the view cube, or over it if the scene is narrow; buttons without room in a row stand below
/// each other.
void NoticeBar::fitWidth() {
  const int whole = parentWidget()->width() - 2 * kNoticeMargin;
  const int width = std::min(kWidestNotice, whole - rightMargin_ < kNarrowNotice ? whole : whole - rightMargin_);
  const QMargins margins = layout()->contentsMargins();
  const bool row = buttonsWidth() <= width - margins.left() - margins.right();
  buttons_->setDirection(row ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  setFixedWidth(width);
  layout()->activate();
  const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
  setGeometry(kNoticeMargin, kNoticeMargin, width, height);
}

int NoticeBar::buttonsWidth() const {
  int width = 0;
  for (int i = 0; i < buttons_->count(); ++i) {
    if (const QWidget* button = buttons_->itemAt(i)->widget()) width += button->sizeHint().width() + kButtonGap;
  }
  return width;
}

bool NoticeBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) fitWidth();
  return QFrame::eventFilter(watched, event);
}

bool NoticeBar::event(QEvent* event) {
  if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) emit changed();
  return QFrame::event(event);
}

void NoticeBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) {
    QFrame::keyPressEvent(event);
    return;
  }
  hide();
  emit closed();
}

}  // namespace glissade
