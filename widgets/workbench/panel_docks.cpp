#include "widgets/workbench/panel_docks.h"

#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QFontMetrics>
#include <QScrollArea>
#include <QStyle>
#include <QTabBar>
#include <QToolBar>
#include <QTreeView>

#include <algorithm>

namespace glissade {
namespace {

/// Largest minimum width of a panel: a screen of 1920 pixels at 200 % has room for two columns of this width beside the
/// scene.
constexpr int kWidestLeast = 300;
constexpr int kLeftWidth = 325;
constexpr int kLeastSceneWidth = 280;
constexpr int kLeastStackedHeight = 600;   ///< minimum height of a window with two panels above each other
constexpr double kUsualTextHeight = 15.0;  ///< pixels, for 9 points
/// Minimum height of a list: a header and a row, so that a small screen has room for two panels above each other.
constexpr int kLeastListHeight = 36;

Qt::DockWidgetArea areaOf(DockPlace place) {
  return place == DockPlace::Left ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea;
}

/// Scrolls a panel. It is as wide as the panel and a scroll bar, but at most kWidestLeast; its width follows the size
/// of texts.
class PanelScroll final : public QScrollArea {
 public:
  PanelScroll(const glissade::Panel& panel, QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(panel.title);
    setWidget(panel.content);
  }

  QSize minimumSizeHint() const override {
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    const int whole = widget()->minimumSizeHint().width() + bar;
    return {std::min(whole, kWidestLeast), QScrollArea::minimumSizeHint().height()};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

/// Lets tab bars scroll if they have no room for all tabs, so that the names on tabs are not cut.
class WholeTabNames final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ChildPolished) {
      auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
      if (tabs == nullptr) return false;
      tabs->setUsesScrollButtons(true);
      tabs->setElideMode(Qt::ElideNone);
    }
    return QObject::eventFilter(watched, event);
  }
};

QWidget* scrolled(const Panel& panel, QDockWidget* dock) {
  if (panel.scrolling == Scrolling::Whole) return new PanelScroll(panel, dock);
  for (QTreeView* list : panel.content->findChildren<QTreeView*>()) list->setMinimumHeight(kLeastListHeight);
  return panel.content;
}

/// The widgets of a dock that Tab stops at, in their present order.
std::vector<QWidget*> tabStopsOf(QDockWidget& dock) {
  std::vector<QWidget*> stops;
  for (QWidget* at = dock.nextInFocusChain(); at != &dock; at = at->nextInFocusChain()) {
    const bool stopsTab = (at->focusPolicy() & Qt::TabFocus) != 0 && at->focusProxy() == nullptr;
    if (stopsTab && dock.isAncestorOf(at)) stops.push_back(at);
  }
  return stops;
}

}  // namespace

QList<QDockWidget*> docksInOrder(const QMainWindow& window) {
  QList<QDockWidget*> docks = window.findChildren<QDockWidget*>();
  std::sort(docks.begin(), docks.end(), [](const QDockWidget* a, const QDockWidget* b) {
    return a->property(kPanelNumber).toInt() < b->property(kPanelNumber).toInt();
  });
  return docks;
}

PanelDocks::PanelDocks(QMainWindow& window, const ActionCatalogue& actions) : window_(window), actions_(actions) {
  window.installEventFilter(new WholeTabNames(&window));
}

void PanelDocks::add(const Panel& panel) {
  auto* dock = new QDockWidget(panel.title, &window_);
  dock->setObjectName(QLatin1String(panel.id));
  dock->setProperty(kPanelAction, QLatin1String(panel.action));
  dock->setProperty(kPanelNumber, static_cast<int>(docks_.size()));
  if (panel.action[0] != '\0') {
    QObject::connect(actions_[QLatin1String(panel.action)], &QAction::triggered, dock, [dock, content = panel.content] {
      dock->show();
      dock->raise();
      if (auto* list = content->findChild<QTreeView*>()) list->setFocus(Qt::ShortcutFocusReason);
    });
  }
  if (panel.scrolling == Scrolling::Table) {
    QObject::connect(dock, &QDockWidget::visibilityChanged, dock, [this, dock](bool visible) {
      if (visible && window_.isVisible()) makeRoomForTable(*dock);
    });
  }
  dock->setWidget(scrolled(panel, dock));
  docks_.push_back({panel, dock});
}

void PanelDocks::makeRoomForTable(QDockWidget& dock) {
  constexpr int kWidth = 455;
  constexpr double kHeight = 0.57;  // share of the window's height
  constexpr const char* kHasRoom = "has-room";
  if (inOneColumn_ || dock.isFloating() || dock.property(kHasRoom).toBool()) return;
  dock.setProperty(kHasRoom, true);
  const int height = static_cast<int>(kHeight * window_.height());
  window_.resizeDocks({&dock}, {std::max(dock.width(), kWidth)}, Qt::Horizontal);
  window_.resizeDocks({&dock}, {std::max(dock.height(), height)}, Qt::Vertical);
}

void PanelDocks::orderTabStops() {
  QWidget* last = window_.centralWidget();
  for (const Dock& dock : docks_) {
    for (QWidget* stop : tabStopsOf(*dock.widget)) {
      QWidget::setTabOrder(last, stop);
      last = stop;
    }
  }
}

QDockWidget* PanelDocks::firstOf(DockPlace place) const {
  const auto first =
      std::find_if(docks_.begin(), docks_.end(), [place](const Dock& dock) { return dock.panel.place == place; });
  return first->widget;
}

/// The width at which the tabs of the lower panels show their names, which are longer in French.
int PanelDocks::usualRightWidth() const {
  constexpr int kAroundName = 26;
  const QFontMetrics metrics(window_.font());
  int tabs = 0;
  for (const Dock& dock : docks_) {
    const bool isThere =
        dock.panel.place == DockPlace::LowerRight && (!dock.panel.hasContent || dock.panel.hasContent());
    if (isThere) tabs += metrics.horizontalAdvance(dock.widget->windowTitle()) + kAroundName;
  }
  return std::clamp(tabs, static_cast<int>(340 * textScale()), static_cast<int>(400 * textScale()));
}

double PanelDocks::textScale() const {
  return std::max(1.0, QFontMetrics(QApplication::font()).height() / kUsualTextHeight);
}

bool PanelDocks::isSmall() const {
  return room_.width() < static_cast<int>(2 * kWidestLeast * textScale()) + kLeastSceneWidth ||
         room_.height() < static_cast<int>(kLeastStackedHeight * textScale());
}

void PanelDocks::setRoom(const QSize& room) {
  room_ = room;
  const QSize least = window_.minimumSizeHint();
  if (isSmall() != inOneColumn_ || least.width() > room.width() || least.height() > room.height()) arrange();
}

/// Hides the titles of docks in one column, where the tabs show the same names.
void PanelDocks::showTitles() {
  for (const Dock& dock : docks_) {
    QWidget* before = dock.widget->titleBarWidget();
    if ((before != nullptr) == inOneColumn_) continue;
    dock.widget->setTitleBarWidget(inOneColumn_ ? new QWidget(dock.widget) : nullptr);
    delete before;
  }
}

/// Makes the panels of a place tabs, because small screens have no room for all of them at once.
void PanelDocks::tabify(QDockWidget* first, DockPlace place) {
  QDockWidget* before = first;
  for (const Dock& dock : docks_) {
    if (dock.widget == first || (!inOneColumn_ && dock.panel.place != place)) continue;
    window_.tabifyDockWidget(before, dock.widget);
    before = dock.widget;
  }
}

void PanelDocks::arrange() {
  inOneColumn_ = isSmall();
  showTitles();
  for (const Dock& dock : docks_) window_.removeDockWidget(dock.widget);
  for (const DockPlace place : {DockPlace::Left, DockPlace::UpperRight, DockPlace::LowerRight}) {
    if (inOneColumn_ && place != DockPlace::Left) continue;
    window_.addDockWidget(inOneColumn_ ? Qt::RightDockWidgetArea : areaOf(place), firstOf(place));
    tabify(firstOf(place), place);
  }
  for (const Dock& dock : docks_) {
    dock.widget->setFloating(false);
    dock.widget->show();
  }
  for (const Dock& dock : docks_) {
    if (dock.panel.hasContent) dock.widget->setVisible(dock.panel.hasContent());
  }
  for (QToolBar* tools : window_.findChildren<QToolBar*>(QStringLiteral("tools"))) tools->show();
  QDockWidget* left = firstOf(DockPlace::Left);
  if (inOneColumn_) {
    left->raise();
    const int widest = std::max(kWidestLeast, room_.width() - kLeastSceneWidth);
    window_.resizeDocks({left}, {std::min(static_cast<int>(kLeftWidth * textScale()), widest)}, Qt::Horizontal);
    return;
  }
  QDockWidget* upper = firstOf(DockPlace::UpperRight);
  QDockWidget* lower = firstOf(DockPlace::LowerRight);
  upper->raise();
  lower->raise();
  window_.resizeDocks({left, upper}, {static_cast<int>(kLeftWidth * textScale()), usualRightWidth()}, Qt::Horizontal);
  window_.resizeDocks({upper, lower}, {330, 300}, Qt::Vertical);
}

}  // namespace glissade
