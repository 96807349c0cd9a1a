// Every interactive widget has a name for screen readers and can be reached by Tab, in English and in French.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTextEdit>
#include <QToolBar>
#include <QtTest>

#include <cmath>
#include <map>
#include <set>

#include "app/window/theme.h"
#include "engine/files/scenario_io.h"
#include "tests/app/every_dialog.h"
#include "tests/app/whole_window.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {
namespace {

/// Whether a person operates the widget. Parts of other widgets (the field of a spin box, scroll bars) are left out.
bool isOperated(const QWidget& widget) {
  if (widget.objectName().startsWith(QStringLiteral("qt_"))) return false;
  if (qobject_cast<const QScrollBar*>(&widget) != nullptr || widget.inherits("QLineEditIconButton") ||
      qobject_cast<const QMainWindow*>(widget.parentWidget()) != nullptr) {
    return false;
  }
  for (const QWidget* above = widget.parentWidget(); above != nullptr; above = above->parentWidget()) {
    if (qobject_cast<const QAbstractSpinBox*>(above) != nullptr || qobject_cast<const QComboBox*>(above) != nullptr ||
        qobject_cast<const QTabBar*>(above) != nullptr) {
      return false;
    }
    if (above->isWindow()) break;
  }
  if (qobject_cast<const QAbstractScrollArea*>(widget.parentWidget()) != nullptr &&
      qobject_cast<const QAbstractButton*>(&widget) != nullptr) {
    return false;  // the corner of a table
  }
  return (widget.focusPolicy() & Qt::TabFocus) != 0 || qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSlider*>(&widget) != nullptr;
}

/// Whether the widget needs no Tab: a button of a tool bar with an action of the menus, or a button that Qt puts on
/// docks.
bool hasOtherKeys(const QWidget& widget) {
  if (widget.inherits("QDockWidgetTitleButton")) return true;
  return widget.inherits("QToolButton") && qobject_cast<const QToolBar*>(widget.parentWidget()) != nullptr &&
         !widget.actions().isEmpty();
}

QString nameOf(QWidget& widget) {
  const QAccessibleInterface* face = QAccessible::queryAccessibleInterface(&widget);
  return face == nullptr ? QString() : face->text(QAccessible::Name).trimmed();
}

/// Describes a widget and its parents, such as "QComboBox 'theme' < QDialog 'preferences' <".
std::string whereIs(const QWidget& widget) {
  QString text;
  for (const QWidget* one = &widget; one != nullptr; one = one->parentWidget()) {
    const auto* label = qobject_cast<const QAbstractButton*>(one);
    text += QStringLiteral("%1 '%2' %3 < ")
                .arg(QLatin1String(one->metaObject()->className()), one->objectName(),
                     label != nullptr ? label->text() : one->toolTip().left(30));
    if (one->isWindow() || qobject_cast<const QDockWidget*>(one) != nullptr) break;
  }
  return text.toStdString();
}

std::vector<QWidget*> operatedIn(QWidget& root) {
  std::vector<QWidget*> operated;
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    if (widget->window() == root.window() && isOperated(*widget)) operated.push_back(widget);
  }
  return operated;
}

void expectNames(QWidget& root) {
  for (QWidget* widget : operatedIn(root)) EXPECT_FALSE(nameOf(*widget).isEmpty()) << "no name: " << whereIs(*widget);
}

/// Presses Tab 400 times and expects that every operated widget had the focus.
void expectReachedByTab(QWidget& root) {
  QWidget* window = root.window();
  window->show();
  QApplication::setActiveWindow(window);
  QApplication::processEvents();
  std::set<QWidget*> reached;
  for (int presses = 0; presses < 400; ++presses) {
    QWidget* focused = window->focusWidget() != nullptr ? window->focusWidget() : window;
    QTest::keyClick(focused, Qt::Key_Tab);
    if (window->focusWidget() != nullptr) reached.insert(window->focusWidget());
  }
  for (QWidget* widget : operatedIn(root)) {
    if (!widget->isVisible() || !widget->isEnabled() || hasOtherKeys(*widget)) continue;
    // Radio buttons and tabs of one group are one stop of Tab; arrow keys reach the others.
    EXPECT_TRUE(reached.count(widget) == 1 || reached.count(widget->focusProxy()) == 1)
        << "not reached by Tab: " << whereIs(*widget);
  }
}

using AccessibilityTest = test::WholeWindowTest;

double luminance(const QColor& colour) {
  const auto linear = [](double share) {
    return share <= 0.03928 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

/// The contrast as WCAG 2.1 defines it.
double contrast(const QColor& one, const QColor& other) {
  const double a = luminance(one);
  const double b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

constexpr double kLeastContrast = 4.5;

TEST_P(AccessibilityTest, TextsStandOutInBothThemes) {
  using Role = QPalette::ColorRole;
  const std::pair<Role, std::vector<Role>> texts[] = {
      {QPalette::WindowText, {QPalette::Window}},
      {QPalette::Text, {QPalette::Base, QPalette::AlternateBase}},
      {QPalette::ButtonText, {QPalette::Button, QPalette::Window}},
      {QPalette::ToolTipText, {QPalette::ToolTipBase}},
      {QPalette::HighlightedText, {QPalette::Highlight}},
      {QPalette::PlaceholderText, {QPalette::Base, QPalette::AlternateBase, QPalette::Window}},
      {QPalette::Link, {QPalette::Base, QPalette::Window}},
      {QPalette::LinkVisited, {QPalette::Base, QPalette::Window}},
      {QPalette::BrightText, {QPalette::Base, QPalette::AlternateBase, QPalette::Window}},
  };
  const auto window = makeWindow();
  ASSERT_EQ(window->openScenario(sample("teaching"), true), std::nullopt);
  window->show();
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    window->setTheme(theme);
    QApplication::processEvents();
    for (const auto& [text, grounds] : texts) {
      for (const Role ground : grounds) {
        const QPalette palette = QApplication::palette();
        EXPECT_GE(contrast(palette.color(text), palette.color(ground)), kLeastContrast) << text << " on " << ground;
      }
    }
    // Labels may have their own style sheet with colours.
    for (QLabel* label : window->findChildren<QLabel*>()) {
      label->ensurePolished();
      const QPalette palette = label->palette();
      EXPECT_GE(contrast(palette.color(QPalette::Active, label->foregroundRole()),
                         palette.color(QPalette::Active, label->backgroundRole())),
                kLeastContrast)
          << whereIs(*label);
    }
  }
}

TEST_P(AccessibilityTest, TheThemeIsTheDesktopsUntilAnotherIsChosen) {
  QApplication::setPalette(QPalette(Qt::black));
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("settings.ini"));
  auto window = makeWindow();
  window->remember(std::make_unique<WindowMemory>(file), true);
  QAction* dark = window->workbench().actions["view.dark"];
  EXPECT_TRUE(dark->isChecked());
  EXPECT_EQ(WindowMemory(file).preferences().theme, ThemeChoice::Desktop);
  dark->setChecked(false);
  EXPECT_EQ(WindowMemory(file).preferences().theme, ThemeChoice::Light);
  QApplication::setPalette(QPalette(Qt::black));
  window = makeWindow();
  window->remember(std::make_unique<WindowMemory>(file), true);
  EXPECT_FALSE(window->workbench().actions["view.dark"]->isChecked());
}

TEST_P(AccessibilityTest, OfTheWindowAndItsPanels) {
  const auto window = makeWindow();
  ASSERT_EQ(window->openScenario(sample("teaching"), true), std::nullopt);
  window->show();
  for (const char* script : {"action environment.build", "select-strategy gts"}) {
    const QStringList words = QString::fromLatin1(script).split(QLatin1Char(' '));
    EXPECT_TRUE(window->workbench().scripts.carryOut(words[0].toStdString(), {words[1].toStdString()}));
  }
  expectNames(*window);
  test::forEachPanel(*window, [](QDockWidget& dock) {
    EXPECT_FALSE(dock.windowTitle().isEmpty());
    expectReachedByTab(dock);
  });
}

TEST_P(AccessibilityTest, OfTheDialogs) {
  const auto window = makeWindow();
  ASSERT_EQ(window->openScenario(sample("teaching"), true), std::nullopt);
  const test::EveryDialog every(*window);
  for (const auto& dialog : every.dialogs()) {
    SCOPED_TRACE(dialog->metaObject()->className());
    EXPECT_FALSE(dialog->windowTitle().isEmpty());
    expectNames(*dialog);
    expectReachedByTab(*dialog);
    dialog->hide();
  }
}

TEST_P(AccessibilityTest, NoTwoActionsHaveOneShortcut) {
  const auto window = makeWindow();
  QHash<QString, QString> owners;
  for (const QAction* action : window->findChildren<QAction*>()) {
    for (const QKeySequence& keys : action->shortcuts()) {
      const QString key = keys.toString();
      EXPECT_FALSE(owners.contains(key)) << key.toStdString() << ": " << owners[key].toStdString() << ", "
                                         << action->text().toStdString();
      owners[key] = action->text();
    }
  }
}

/// A cube between two blocks; `tail` is added to all names.
Scenario scenarioWithNames(const std::string& tail) {
  Scenario scenario;
  scenario.object.first().id = "cube";
  scenario.object.first().name = "cube" + tail;
  scenario.object.first().geometry = BoxGeometry{{0.2, 0.2, 0.2}};
  for (const double side : {-1.0, 1.0}) {
    BodyDescription block;
    block.id = side < 0.0 ? BodyId("left") : BodyId("right");
    block.name = block.id.text() + tail;
    block.geometry = BoxGeometry{{0.2, 1.0, 1.0}};
    block.pose.position.x() = side * 0.3;
    scenario.bodies.push_back(block);
  }
  scenario.goal = Pose::translation({0.0, 0.0, 1.5});
  scenario.workspace = Box3(Vector3::Constant(-2.0), Vector3::Constant(2.0));
  scenario.planner = "gts";
  return scenario;
}

/// The minimum widths of the docks after all of their contents exist.
std::map<QString, int> leastWidths(MainWindow& window, const Scenario& scenario, const QString& file,
                                   const std::string& pathName) {
  QFile out(file);
  EXPECT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(QByteArray::fromStdString(writeScenario(scenario)));
  out.close();
  EXPECT_EQ(window.openScenario(file, true), std::nullopt);
  const std::vector<std::vector<std::string>> script{
      {"action", "environment.build"}, {"action", "run.start"},   {"wait", "ended", "20000"}, {"action", "paths.keep"},
      {"rename-path", "@1", pathName}, {"action", "fits.find"},   {"action", "joints.find"},  {"plan-sequence", "all"},
      {"select-steps", "1", "1"},      {"select", "body", "left"}};
  for (const auto& line : script) {
    const Outcome done = window.workbench().scripts.carryOut(line[0], {line.begin() + 1, line.end()});
    EXPECT_TRUE(done) << line[0] << " " << line[1] << ": " << toString(done.error());
  }
  std::map<QString, int> widths;
  test::forEachPanel(window, [&widths](const QDockWidget& dock) {
    int& width = widths[dock.objectName()];
    width = std::max({width, dock.minimumSizeHint().width(), dock.minimumWidth()});
  });
  widths[QStringLiteral("whole")] = window.minimumSizeHint().width();
  return widths;
}

TEST_P(AccessibilityTest, NoNameWidensAPanel) {
  const QTemporaryDir folder;
  const auto window = makeWindow();
  window->show();
  const auto usual = leastWidths(*window, scenarioWithNames(""), folder.filePath(QStringLiteral("a.json")), "path");
  std::string tail;
  for (int i = 0; i < 12; ++i) tail += "-much-name";
  const auto lengthy =
      leastWidths(*window, scenarioWithNames(tail), folder.filePath(QStringLiteral("b.json")), "path" + tail);
  for (const auto& [dock, width] : usual) EXPECT_LE(lengthy.at(dock), width) << dock.toStdString();
  // The size of a screen of 1920 x 1080 pixels at 200 %.
  window->fitInto({960, 540});
  EXPECT_LE(window->minimumSizeHint().width(), 960);
  EXPECT_LE(window->minimumSizeHint().height(), 540);
}

INSTANTIATE_TEST_SUITE_P(Languages, AccessibilityTest, testing::Values("en", "fr"));

}  // namespace
}  // namespace glissade
