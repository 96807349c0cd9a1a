#include "widgets/workbench/panel_docks.h"

#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QFontMetrics>
#include <QScrollArea>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolBar>
#include <QTreeView>

#include <algorithm>

namespace glissade {
namespace {

/// Grows when docks are added, renamed, or shown at first elsewhere, because an older layout would hide them.
constexpr int kLayoutVersion = 4;

/// Largest minimum width of a panel: a screen of 1920 pixels at 200 % has room for two columns of this width beside the
/// scene.
constexpr int kWidestLeast = 300;
constexpr int kLeftWidth = 325;
constexpr int kRightWidth = 350;
constexpr int kTableWidth = 455;
constexpr int kLeastSceneWidth = 280;
constexpr int kLeastStackedHeight = 600;   ///< minimum height of a window with two panels above each other
constexpr double kUsualTextHeight = 15.0;  ///< pixels, for 9 points
/// Minimum height of a list: a header and a row, so that a small screen has room for two panels above each other.
constexpr int kLeastListHeight = 36;

/// Property of a panel: the id of the action that raises it; empty: none.
constexpr const char* kPanelAction = "panel-action";
/// Property of a dock: its number in the order in which the docks were added.
constexpr const char* kDockNumber = "number";
/// Property of a panel with a table that got its room.
constexpr const char* kHasRoom = "has-room";

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

/// Lets a tab bar scroll if it has no room for all tabs, so that the names on tabs are not cut.
void showWholeNames(QTabBar& tabs) {
  tabs.setUsesScrollButtons(true);
  tabs.setElideMode(Qt::ElideNone);
}

/// A panel that floats is behind a window that is shown later.
void raiseFloating(QMainWindow& window) {
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    if (dock->isFloating() && !dock->isHidden()) dock->raise();
  }
}

/// Shows the whole names on the tabs that the window makes for docks at the same place, and raises panels that float.
class TabsAndFloats final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ChildPolished) {
      auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
      if (tabs != nullptr) showWholeNames(*tabs);
    } else if (event->type() == QEvent::Show) {
      auto* window = static_cast<QMainWindow*>(watched);
      QTimer::singleShot(0, window, [window] { raiseFloating(*window); });
    }
    return QObject::eventFilter(watched, event);
  }
};

QWidget* scrolled(const Panel& panel, QWidget* parent) {
  if (panel.scrolling == Scrolling::Whole) return new PanelScroll(panel, parent);
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
    return a->property(kDockNumber).toInt() < b->property(kDockNumber).toInt();
  });
  return docks;
}

std::vector<NamedPanel> panelsInOrder(const QMainWindow& window) {
  std::vector<NamedPanel> panels;
  for (const QDockWidget* dock : docksInOrder(window)) {
    const auto* tabs = qobject_cast<const QTabWidget*>(dock->widget());
    for (int i = 0; tabs != nullptr && i < tabs->count(); ++i) {
      QString title = dock->windowTitle();
      if (tabs->count() > 1) title += QStringLiteral(" > ") + tabs->tabText(i);
      panels.push_back({tabs->widget(i)->objectName(), title, tabs->widget(i)->property(kPanelAction).toString()});
    }
  }
  return panels;
}

const QWidget* panelOf(const QWidget* widget) {
  while (widget != nullptr && !widget->property(kPanelAction).isValid()) widget = widget->parentWidget();
  return widget;
}

PanelDocks::PanelDocks(QMainWindow& window, const ActionCatalogue& actions) : window_(window), actions_(actions) {
  window.installEventFilter(new TabsAndFloats(&window));
}

void PanelDocks::addDock(const DockSpec& spec) {
  auto* dock = new QDockWidget(spec.title, &window_);
  dock->setObjectName(QLatin1String(spec.id));
  dock->setProperty(kDockNumber, static_cast<int>(docks_.size()));
  auto* tabs = new QTabWidget(dock);
  tabs->setDocumentMode(true);
  tabs->setTabBarAutoHide(true);
  // The bar takes the focus itself: a proxy that is hidden would stop Tab.
  tabs->setFocusProxy(nullptr);
  tabs->setFocusPolicy(Qt::NoFocus);
  showWholeNames(*tabs->tabBar());
  tabs->tabBar()->setAccessibleName(spec.title);
  const auto makeRoom = [this, dock, tabs] {
    const bool isSeen = window_.isVisible() && dock->isVisible() && tabs->currentWidget() != nullptr;
    if (isSeen && tabs->currentWidget()->property(kHasRoom).isValid()) makeRoomForTable(*dock, *tabs->currentWidget());
  };
  QObject::connect(dock, &QDockWidget::visibilityChanged, dock, [makeRoom](bool visible) {
    if (visible) makeRoom();
  });
  QObject::connect(tabs, &QTabWidget::currentChanged, dock, makeRoom);
  dock->setWidget(tabs);
  docks_.push_back({spec, dock, tabs});
}

const PanelDocks::Dock& PanelDocks::dockOf(const char* id) const {
  return *std::find_if(docks_.begin(), docks_.end(),
                       [id](const Dock& dock) { return QLatin1String(dock.spec.id) == QLatin1String(id); });
}

void PanelDocks::add(const Panel& panel) {
  const Dock& dock = dockOf(panel.dock);
  QWidget* page = scrolled(panel, dock.tabs);
  page->setObjectName(QLatin1String(panel.id));
  page->setProperty(kPanelAction, QLatin1String(panel.action));
  if (panel.scrolling == Scrolling::Table) page->setProperty(kHasRoom, false);
  dock.tabs->addTab(page, panel.title);
  if (panel.action[0] == '\0') return;
  QObject::connect(actions_[QLatin1String(panel.action)], &QAction::triggered, page,
                   [widget = dock.widget, tabs = dock.tabs, page, content = panel.content] {
                     tabs->setCurrentWidget(page);
                     widget->show();
                     widget->raise();
                     if (auto* list = content->findChild<QTreeView*>()) list->setFocus(Qt::ShortcutFocusReason);
                   });
}

void PanelDocks::makeRoomForTable(QDockWidget& dock, QWidget& page) {
  constexpr double kHeight = 0.57;  // share of the window's height
  if (inOneColumn_ || dock.isFloating() || page.property(kHasRoom).toBool()) return;
  page.setProperty(kHasRoom, true);
  const int height = static_cast<int>(kHeight * window_.height());
  window_.resizeDocks({&dock}, {std::max(dock.width(), kTableWidth)}, Qt::Horizontal);
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

bool PanelDocks::isShownAtFirst(const Dock& dock) const {
  if (inOneColumn_ && dock.spec.needsRoom) return false;
  return std::find(dock.spec.workspaces.begin(), dock.spec.workspaces.end(), workspace_) != dock.spec.workspaces.end();
}

DockPlace PanelDocks::placeOf(const Dock& dock) const {
  return workspace_ == Workspace::Assembly ? dock.spec.placeInAssembly.value_or(dock.spec.place) : dock.spec.place;
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
  if (isSmall() != inOneColumn_) layouts_.clear();
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

/// Puts docks to one place of the window, as tabs; the first one that is shown is in front.
QDockWidget* PanelDocks::putTogether(Qt::DockWidgetArea area, const std::vector<const Dock*>& docks) {
  QDockWidget* front = nullptr;
  for (const Dock* dock : docks) {
    dock->widget->setFloating(false);
    window_.addDockWidget(area, dock->widget);
    if (dock != docks.front()) window_.tabifyDockWidget(docks.front()->widget, dock->widget);
    dock->widget->setVisible(isShownAtFirst(*dock));
    if (front == nullptr && isShownAtFirst(*dock)) front = dock->widget;
  }
  if (front != nullptr) front->raise();
  return front;
}

void PanelDocks::arrange() {
  inOneColumn_ = isSmall();
  showTitles();
  for (const Dock& dock : docks_) window_.removeDockWidget(dock.widget);
  for (QToolBar* tools : window_.findChildren<QToolBar*>(QStringLiteral("tools"))) tools->show();
  if (inOneColumn_) {
    arrangeInOneColumn();
  } else {
    arrangeInColumns();
  }
}

void PanelDocks::arrangeInOneColumn() {
  std::vector<const Dock*> all;
  for (const Dock& dock : docks_) all.push_back(&dock);
  QDockWidget* front = putTogether(Qt::RightDockWidgetArea, all);
  const int widest = std::max(kWidestLeast, room_.width() - kLeastSceneWidth);
  if (front != nullptr) {
    window_.resizeDocks({front}, {std::min(static_cast<int>(kLeftWidth * textScale()), widest)}, Qt::Horizontal);
  }
}

void PanelDocks::arrangeInColumns() {
  QList<QDockWidget*> widths;
  QList<QDockWidget*> heights;
  for (const DockPlace place : {DockPlace::Left, DockPlace::UpperRight, DockPlace::LowerRight}) {
    std::vector<const Dock*> docks;
    for (const Dock& dock : docks_) {
      if (placeOf(dock) == place) docks.push_back(&dock);
    }
    QDockWidget* front = putTogether(areaOf(place), docks);
    if (front == nullptr) continue;
    widths << front;
    if (place != DockPlace::Left) heights << front;
  }
  for (QDockWidget* dock : widths) {
    const bool isLeft = window_.dockWidgetArea(dock) == Qt::LeftDockWidgetArea;
    window_.resizeDocks({dock}, {static_cast<int>((isLeft ? kLeftWidth : kRightWidth) * textScale())}, Qt::Horizontal);
  }
  if (heights.size() == 2) window_.resizeDocks(heights, {330, 300}, Qt::Vertical);
}

void PanelDocks::show(Workspace workspace) {
  if (workspace == workspace_) return;
  layouts_ = layouts();
  workspace_ = workspace;
  restore();
}

void PanelDocks::bringForward(const char* dock) {
  QDockWidget* widget = dockOf(dock).widget;
  if (!widget->isHidden()) widget->raise();
}

/// Shows the present workspace as it was left. Tool bars do not belong to workspaces.
void PanelDocks::restore() {
  const QByteArray layout = layouts_.value(workspace_);
  QList<QToolBar*> hidden;
  for (QToolBar* bar : window_.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (bar->isHidden()) hidden << bar;
  }
  if (layout.isEmpty() || !window_.restoreState(layout, kLayoutVersion)) arrange();
  for (QToolBar* bar : window_.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    bar->setHidden(hidden.contains(bar));
  }
  raiseFloating(window_);
}

PanelDocks::Layouts PanelDocks::layouts() const {
  Layouts all = layouts_;
  all[workspace_] = window_.saveState(kLayoutVersion);
  return all;
}

void PanelDocks::setLayouts(const Layouts& layouts, Workspace workspace) {
  layouts_ = layouts;
  workspace_ = workspace;
  restore();
}

}  // namespace glissade
