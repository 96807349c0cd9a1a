#pragma once

#include <QMainWindow>
#include <functional>
#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// Property of a panel's dock: the id of the action that raises it; empty: none.
inline constexpr const char* kPanelAction = "action";
/// Property of a panel's dock: its number in the order in which the panels were added.
inline constexpr const char* kPanelNumber = "number";

/// The docks in the order in which they were added.
QList<QDockWidget*> docksInOrder(const QMainWindow& window);

/// The first place of a panel. Panels of one place share it as tabs, in the order in which they were added.
enum class DockPlace { Left, UpperRight, LowerRight };

/// How a panel scrolls: a panel of fixed rows as a whole, a panel with lists in its lists. A table of many columns also
/// gets room when it is raised.
enum class Scrolling { Whole, Own, Table };

struct Panel {
  QString title;
  const char* id;  ///< object name of the dock; its layout is remembered by this name
  QWidget* content;
  DockPlace place;
  const char* action = "";  ///< id of the action that raises the panel and gives the focus to its list
  Scrolling scrolling = Scrolling::Whole;
  std::function<bool()> hasContent = {};  ///< if false, the panel is hidden at first; empty: the panel is always shown
};

/// The docks of the window's panels, and their first layout.
class PanelDocks final {
 public:
  PanelDocks(QMainWindow& window, const ActionCatalogue& actions);

  void add(const Panel& panel);
  /// Lets Tab go through the panels in the order in which they were added.
  void orderTabStops();
  /// Puts all docks and tool bars to their first places: beside the scene on both sides, or all as tabs of one column
  /// if the window is too small for that.
  void arrange();
  /// Sets the maximum size of the window, pixels. Arranges the docks again if they do not fit.
  void setRoom(const QSize& room);

 private:
  struct Dock {
    Panel panel;
    QDockWidget* widget;
  };
  QDockWidget* firstOf(DockPlace place) const;
  int usualRightWidth() const;
  void tabify(QDockWidget* first, DockPlace place);
  bool isSmall() const;
  /// Makes a raised dock large enough for a table of some rows with buttons, unless it floats. It does so once for each
  /// dock; afterwards the person sets the size.
  void makeRoomForTable(QDockWidget& dock);
  void showTitles();
  /// Ratio of the present size of texts to the usual one, at least 1.
  double textScale() const;

  QMainWindow& window_;
  const ActionCatalogue& actions_;
  std::vector<Dock> docks_;
  QSize room_{1280, 720};
  bool inOneColumn_ = false;
};

}  // namespace glissade
