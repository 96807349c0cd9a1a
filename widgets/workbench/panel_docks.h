#pragma once

#include <QMainWindow>
#include <QMap>

#include <optional>
#include <vector>

#include "widgets/controls/action_catalogue.h"
#include "widgets/workbench/workspace.h"

class QTabWidget;

namespace glissade {

/// The first place of a dock. Docks of one place share it as tabs, in the order in which they were added.
enum class DockPlace { Left, UpperRight, LowerRight };

/// How a panel scrolls: a panel of fixed rows as a whole, a panel with lists in its lists. A table of many columns also
/// gets room when it is raised.
enum class Scrolling { Whole, Own, Table };

struct DockSpec {
  QString title;
  const char* id;  ///< object name of the dock; its layout is remembered by this name
  DockPlace place;
  std::vector<Workspace> workspaces;                        ///< that show the dock at first
  std::optional<DockPlace> placeInAssembly = std::nullopt;  ///< its place in that workspace, if it is another
  bool needsRoom = false;  ///< it is not shown at first where all docks are tabs of one column
};

/// A panel of a dock. Several panels of one dock are its tabs.
struct Panel {
  const char* dock;
  QString title;   ///< of its tab; a dock of one panel shows only its own title
  const char* id;  ///< object name of the panel
  QWidget* content;
  const char* action = "";  ///< id of the action that raises the panel and gives the focus to its list
  Scrolling scrolling = Scrolling::Whole;
};

/// A panel as the manual names it.
struct NamedPanel {
  QString id;
  QString title;   ///< "Path", or "Path > Kept paths" where the dock has several panels
  QString action;  ///< id of the action that raises it; empty: none
};

/// The panels of the window, in the order of their docks.
std::vector<NamedPanel> panelsInOrder(const QMainWindow& window);
/// The docks in the order in which they were added.
QList<QDockWidget*> docksInOrder(const QMainWindow& window);
/// The panel that contains the widget; null: none.
const QWidget* panelOf(const QWidget* widget);

/// The docks of the window's panels, and their layout in each workspace.
class PanelDocks final {
 public:
  using Layouts = QMap<Workspace, QByteArray>;

  PanelDocks(QMainWindow& window, const ActionCatalogue& actions);

  void addDock(const DockSpec& dock);
  void add(const Panel& panel);
  /// Lets Tab go through the panels in the order in which they were added.
  void orderTabStops();
  /// Puts the docks of the workspace and all tool bars to their first places: beside the scene on both sides, or all as
  /// tabs of one column if the window is too small for that.
  void arrange();
  /// Sets the maximum size of the window, pixels. Arranges the docks again if they do not fit.
  void setRoom(const QSize& room);

  Workspace workspace() const { return workspace_; }
  /// Shows the panels of a workspace as they were left.
  void show(Workspace workspace);
  /// Brings a dock that is shown in front of those at its place.
  void bringForward(const char* dock);
  /// The layouts of the workspaces that were shown.
  Layouts layouts() const;
  void setLayouts(const Layouts& layouts, Workspace workspace);

 private:
  struct Dock {
    DockSpec spec;
    QDockWidget* widget;
    QTabWidget* tabs;
  };
  const Dock& dockOf(const char* id) const;
  bool isShownAtFirst(const Dock& dock) const;
  DockPlace placeOf(const Dock& dock) const;
  QDockWidget* putTogether(Qt::DockWidgetArea area, const std::vector<const Dock*>& docks);
  void restore();
  void arrangeInColumns();
  void arrangeInOneColumn();
  bool isSmall() const;
  /// Makes a raised dock large enough for a table of some rows with buttons, unless it floats. It does so once for each
  /// panel; afterwards the person sets the size.
  void makeRoomForTable(QDockWidget& dock, QWidget& page);
  void showTitles();
  /// Ratio of the present size of texts to the usual one, at least 1.
  double textScale() const;

  QMainWindow& window_;
  const ActionCatalogue& actions_;
  std::vector<Dock> docks_;
  QSize room_{1280, 720};
  bool inOneColumn_ = false;
  Workspace workspace_ = Workspace::Assembly;
  Layouts layouts_;
};

}  // namespace glissade
