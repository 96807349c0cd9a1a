#include "app/window/theme.h"

#include <QApplication>
#include <QFont>
#include <QMenu>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

namespace glissade {
namespace {

struct Tones {
  QColor window, base, alternate, button, text, faint, highlight, link, alarm, border, success;
};

/// The colours of a theme. Every text has a contrast of at least 4.5 against each of its backgrounds
/// (tests/app/accessibility_test.cpp).
Tones tonesOf(Theme theme) {
  if (theme == Theme::Dark) {
    return {QColor("#24272c"), QColor("#1b1d21"), QColor("#212429"), QColor("#31353b"),
            QColor("#e3e6ea"), QColor("#8b929b"), QColor("#2a78b0"), QColor("#6db3e6"),
            QColor("#ff8f75"), QColor("#3d4249"), QColor("#5fd3a4")};
  }
  return {QColor("#f2f4f7"), QColor("#ffffff"), QColor("#f6f8fa"), QColor("#e8ecf1"),
          QColor("#1d2329"), QColor("#636c76"), QColor("#1f6fae"), QColor("#1f6fae"),
          QColor("#b3261e"), QColor("#c9d0d8"), QColor("#00694a")};
}

QPalette paletteFrom(const Tones& tones) {
  QPalette palette;
  palette.setColor(QPalette::Window, tones.window);
  palette.setColor(QPalette::Base, tones.base);
  palette.setColor(QPalette::AlternateBase, tones.alternate);
  palette.setColor(QPalette::Button, tones.button);
  palette.setColor(QPalette::ToolTipBase, tones.base);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, tones.text);
    palette.setColor(QPalette::Disabled, role, tones.faint);
  }
  // Fusion draws disabled text twice, first in this colour. In the dark theme this shadow would be brighter than the
  // text.
  palette.setColor(QPalette::Disabled, QPalette::Light, Qt::transparent);
  palette.setColor(QPalette::PlaceholderText, tones.faint);
  palette.setColor(QPalette::Highlight, tones.highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, tones.link);
  palette.setColor(QPalette::LinkVisited, tones.link);
  palette.setColor(QPalette::BrightText, tones.alarm);
  return palette;
}

QString styleSheetFrom(const Tones& tones) {
  return QStringLiteral(
             "QMainWindow::separator { width: 4px; height: 4px; }"
             "QDockWidget { font-weight: 600; }"
             "QDockWidget::title { padding: 6px 10px; background: %1; border-bottom: 1px solid %2; }"
             "QToolBar { border: none; border-bottom: 1px solid %2; padding: 3px 6px; spacing: 2px; }"
             "QToolButton { padding: 3px 6px; border: 1px solid transparent; border-radius: 4px; }"
             "QDockWidget QToolButton { border: 1px solid %2; background: %3; }"
             "#qt_toolbar_ext_button { padding: 0px; min-width: 14px; }"  // button of entries that have no room in a
                                                                          // narrow window
             "QTabBar QToolButton { padding: 0px; border: 1px solid %2; background: %3; }"  // buttons that scroll tabs
             "QToolButton:hover { background: %3; border: 1px solid %2; }"
             "QToolButton:checked { background: %4; color: white; }"
             "QToolButton:focus { border: 1px solid %4; }"
             "QMenu::separator { height: 1px; background: %2; margin: 3px 6px; }"
             "QStatusBar { border-top: 1px solid %2; }"
             "QStatusBar::item { border: none; }"
             "QStatusBar QToolButton { padding: 0px 6px; }"
             "#welcome QToolButton, #tour QToolButton { padding: 5px 10px; border: 1px solid %5; background: %3; }"
             "#welcome QToolButton:hover, #tour QToolButton:hover { border: 1px solid %4; }"
             "#welcome QToolButton:focus, #tour QToolButton:focus { border: 1px solid %4; }"
             "#tour { background: %1; border: 1px solid %2; border-top: 4px solid %4; border-radius: 4px; }"
             "QTreeWidget { border: none; }"
             "QTreeView::indicator:unchecked, #joint QListView::indicator:unchecked { width: 11px; height: 11px; "
             "border: 1px solid %5; border-radius: 2px; }"
             "#attributes { background: %1; }"  // other editors have this background; on their own colour they would
                                                // have no edge
             "QLabel#authority { font-weight: 600; }"
             "QLabel#status[found=\"true\"] { font-weight: 600; color: %6; }"
             "#scene-hint { background: %1; border: 1px solid %2; border-radius: 4px; }"
             "#notice { background: %1; border: 1px solid %2; border-left: 4px solid #d55e00; border-radius: 4px; }"
             "#arrange-bar { background: %1; border: 1px solid %2; border-radius: 4px; }"
             "#arrange-bar QToolButton { border: 1px solid %2; background: %3; }"
             "#arrange-bar QToolButton:checked { background: %4; color: white; }"
             "#arrange-bar QToolButton:focus { border: 1px solid %4; }"
             "#notice QToolButton, #preferences QToolButton { border: 1px solid %2; background: %3; }"
             "#notice QToolButton:focus, #preferences QToolButton:focus { border: 1px solid %4; }"
             "#calibration QCheckBox::indicator, #joint QCheckBox::indicator, #attributes QCheckBox::indicator { "
             "width: 13px; height: 13px; "
             "border: 1px solid %5; border-radius: 2px; }"
             "#calibration QCheckBox::indicator:focus, #joint QCheckBox::indicator:focus, #attributes "
             "QCheckBox::indicator:focus "
             "{ border: 2px solid %4; }"
             "#calibration QCheckBox::indicator:checked, #joint QCheckBox::indicator:checked, #attributes "
             "QCheckBox::indicator:checked "
             "{ background: %4; border-color: %4; }"
             "#attributes QCheckBox::indicator:indeterminate { background: %5; }")
      .arg(tones.window.name(), tones.border.name(), tones.button.name(), tones.highlight.name(), tones.faint.name(),
           tones.success.name());
}

/// Draws the outlines of menus and of their check boxes in the colour of disabled text. Fusion's outlines are darker
/// than the background, so that they are invisible in the dark theme.
class WorkbenchStyle final : public QProxyStyle {
 public:
  WorkbenchStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isCheckBox = element == PE_IndicatorCheckBox && qobject_cast<const QMenu*>(widget) != nullptr;
    if (!isCheckBox && element != PE_PanelMenu) return;
    painter->save();
    painter->setPen(option->palette.color(QPalette::Disabled, QPalette::Text));
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->restore();
  }
};

}  // namespace

void setFontPoints(double points) {
  QFont font = QApplication::font();
  font.setPointSizeF(points);
  QApplication::setFont(font);
}

void applyTheme(Theme theme) {
  const Tones tones = tonesOf(theme);
  QApplication::setStyle(new WorkbenchStyle);
  QApplication::setPalette(paletteFrom(tones));
  qApp->setStyleSheet(styleSheetFrom(tones));
}

}  // namespace glissade
