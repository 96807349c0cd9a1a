#include "app/window/panel_docks.h"

#include <QDockWidget>
#include <QEvent>
#include <QFontMetrics>
#include <QScrollArea>
#include <QStyle>
#include <QToolBar>
#include <QTreeView>

#include <algorithm>
#include <map>

namespace glissade {
namespace {

/// A screen of 1920 pixels at 200 % has room for two columns of this width beside the scene.
constexpr int kWidestLeast = 300;
/// A header and a row: such a screen has room for two panels above each other.
constexpr int kLeastListHeight = 36;

Qt::DockWidgetArea areaOf(DockPlace place) {
  return place == DockPlace::Left ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea;
}

/// As wide as its panel with a scroll bar, also where the size of texts changes; wider panels are scrolled.
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

void makeRoomForTable(QWidget& panel, QMainWindow& window) {
  constexpr int kWidth = 455;
  constexpr double kHeight = 0.57;  // of the window
  constexpr const char* kHasRoom = "has-room";
  QWidget* widget = &panel;
  while (widget != nullptr && qobject_cast<QDockWidget*>(widget) == nullptr) widget = widget->parentWidget();
  auto* dock = qobject_cast<QDockWidget*>(widget);
  if (dock == nullptr || dock->isFloating() || dock->property(kHasRoom).toBool()) return;
  dock->setProperty(kHasRoom, true);
  const int height = static_cast<int>(kHeight * window.height());
  window.resizeDocks({dock}, {std::max(dock->width(), kWidth)}, Qt::Horizontal);
  window.resizeDocks({dock}, {std::max(dock->height(), height)}, Qt::Vertical);
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
  dock->setWidget(scrolled(panel, dock));
  docks_.push_back({panel, dock});
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

/// The tabs of the lower panels have room for their names, which are longer in French.
int PanelDocks::usualRightWidth() const {
  constexpr int kAroundName = 26;
  const QFontMetrics metrics(window_.font());
  int tabs = 0;
  for (const Dock& dock : docks_) {
    const bool isThere =
        dock.panel.place == DockPlace::LowerRight && (!dock.panel.hasContent || dock.panel.hasContent());
    if (isThere) tabs += metrics.horizontalAdvance(dock.widget->windowTitle()) + kAroundName;
  }
  return std::clamp(tabs, 340, 400);
}

void PanelDocks::arrange() {
  for (const Dock& dock : docks_) window_.removeDockWidget(dock.widget);
  std::map<DockPlace, QDockWidget*> last;
  for (const DockPlace place : {DockPlace::Left, DockPlace::UpperRight, DockPlace::LowerRight}) {
    last[place] = firstOf(place);
    window_.addDockWidget(areaOf(place), last[place]);
  }
  // Panels share a place as tabs: small screens have no room for all of them at once.
  for (const Dock& dock : docks_) {
    QDockWidget*& before = last[dock.panel.place];
    if (dock.widget == firstOf(dock.panel.place)) continue;
    window_.tabifyDockWidget(before, dock.widget);
    before = dock.widget;
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
  QDockWidget* upper = firstOf(DockPlace::UpperRight);
  QDockWidget* lower = firstOf(DockPlace::LowerRight);
  upper->raise();
  lower->raise();
  window_.resizeDocks({left, upper}, {325, usualRightWidth()}, Qt::Horizontal);
  window_.resizeDocks({upper, lower}, {330, 300}, Qt::Vertical);
}

}  // namespace glissade
