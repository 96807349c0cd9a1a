#pragma once

#include <QMainWindow>
#include <functional>
#include <vector>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// Property of a panel's dock: the id of the action that brings it to the front; empty: none.
inline constexpr const char* kPanelAction = "action";
/// Another one: which of the panels it is, in the order in which they were added.
inline constexpr const char* kPanelNumber = "number";

/// The docks in the order in which they were added.
QList<QDockWidget*> docksInOrder(const QMainWindow& window);

/// Where a panel is at first. Panels of one place share it as tabs, in the order in which they were added.
enum class DockPlace { Left, UpperRight, LowerRight };

/// Panels of fixed rows are scrolled as a whole; those with lists scroll these. A table of many columns gets room when
/// it comes to the front.
enum class Scrolling { Whole, Own, Table };

struct Panel {
  QString title;
  const char* id;  ///< object name of the dock, by which its layout is remembered
  QWidget* content;
  DockPlace place;
  const char* action = "";  ///< brings it to the front, and the focus to its list
  Scrolling scrolling = Scrolling::Whole;
  std::function<bool()> hasContent = {};  ///< where it says no, the panel is hidden at first; empty: always shown
};

/// The docks of the window's panels, and their first layout.
class PanelDocks final {
 public:
  PanelDocks(QMainWindow& window, const ActionCatalogue& actions);

  void add(const Panel& panel);
  /// Lets Tab go through the panels in the order in which they were added.
  void orderTabStops();
  /// Puts all docks and tool bars where they are at first: beside the scene on both sides, or, where the window may not
  /// be as large as that, all as tabs of one column.
  void arrange();
  /// The window may be so large, pixels. Arranges the docks anew where they do not fit.
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
  /// Makes a dock that comes to the front large enough for a table of some rows with buttons, unless it floats. Once
  /// for each dock: afterwards its size is the person's.
  void makeRoomForTable(QDockWidget& dock);
  void showTitles();
  /// Sizes of texts beside the usual one.
  double textScale() const;

  QMainWindow& window_;
  const ActionCatalogue& actions_;
  std::vector<Dock> docks_;
  QSize room_{1280, 720};
  bool inOneColumn_ = false;
};

}  // namespace glissade
