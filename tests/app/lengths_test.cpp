// Every length in the texts of the window is in one unit, with few decimals.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QRegularExpression>
#include <QTreeWidget>

#include "tests/app/whole_window.h"
#include "widgets/controls/length_text.h"
#include "widgets/paths/clearance_curve.h"

namespace glissade {
namespace {

void addTexts(const QTreeWidgetItem& item, QStringList& texts) {
  for (int column = 0; column < item.columnCount(); ++column) texts << item.text(column) << item.toolTip(column);
  for (int i = 0; i < item.childCount(); ++i) addTexts(*item.child(i), texts);
}

/// The texts of the widgets of the window.
QStringList textsOf(const MainWindow& window) {
  QStringList texts;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->isHidden() && widget->testAttribute(Qt::WA_WState_ExplicitShowHide)) continue;
    texts << widget->toolTip() << widget->accessibleDescription();
    if (const auto* label = qobject_cast<const QLabel*>(widget)) texts << label->text();
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(widget)) texts << box->text();
    if (const auto* tree = qobject_cast<const QTreeWidget*>(widget)) addTexts(*tree->invisibleRootItem(), texts);
  }
  return texts;
}

struct ShownLength {
  double number;
  int decimals;
  QString unit;
  QString text;
};

std::vector<ShownLength> lengthsIn(const QStringList& texts) {
  static const QRegularExpression kLength(QStringLiteral("(\\d+)(?:\\.(\\d+))? (µm|mm|m|in|µin)(?![\\w²³/])"));
  std::vector<ShownLength> lengths;
  for (const QString& text : texts) {
    for (auto found = kLength.globalMatch(text); found.hasNext();) {
      const QRegularExpressionMatch match = found.next();
      lengths.push_back({match.captured(0).section(QLatin1Char(' '), 0, 0).toDouble(), match.captured(2).size(),
                         match.captured(3), text});
    }
  }
  return lengths;
}

class LengthsTest : public test::WholeWindowTest {
 protected:
  std::vector<ShownLength> lengthsOf(const char* name) {
    EXPECT_EQ(window_->openScenario(sample(name), true), std::nullopt);
    const ScriptCommands& scripts = window_->workbench().scripts;
    EXPECT_TRUE(scripts.carryOut("select-operator", {"expert"}).ok());
    EXPECT_TRUE(scripts.carryOut("action", {"run.start"}).ok());
    EXPECT_TRUE(scripts.carryOut("wait", {"solved", "20000"}).ok());
    EXPECT_TRUE(scripts.carryOut("action", {"paths.keep"}).ok());
    return lengthsIn(textsOf(*window_));
  }

  /// Whether the text is one of the curve of clearance, which has a unit for its least length.
  bool isOfCurve(const ShownLength& length) const {
    return length.text == window_->findChild<ClearanceCurve*>()->accessibleDescription();
  }

  /// The texts are in inches at once when the unit changes.
  void expectInches() {
    const LengthUnit before = lengthUnit();
    const std::size_t shown = lengthsIn(textsOf(*window_)).size();
    setLengthUnit(LengthUnit::Inches);
    announceLengthUnit();
    const std::vector<ShownLength> lengths = lengthsIn(textsOf(*window_));
    EXPECT_GE(lengths.size(), shown);
    for (const ShownLength& length : lengths) {
      const std::string text = length.text.toStdString();
      if (text.find("25.4 mm") != std::string::npos) continue;  // an example of what can be typed
      EXPECT_TRUE(length.unit.endsWith(QLatin1String("in"))) << text;
    }
    setLengthUnit(before);
    announceLengthUnit();
  }

  std::unique_ptr<MainWindow> window_ = makeWindow();
};

TEST_P(LengthsTest, AreInMetresInALargeWorkspace) {
  const std::vector<ShownLength> lengths = lengthsOf("environment-1");
  EXPECT_GT(lengths.size(), 10U);
  for (const ShownLength& length : lengths) {
    const std::string text = length.text.toStdString();
    if (text.find("25.4 mm") != std::string::npos) continue;  // an example of what can be typed
    if (isOfCurve(length)) continue;
    EXPECT_LE(length.decimals, 5) << text;
    EXPECT_TRUE(length.unit != QLatin1String("mm") || length.number < 1.0) << text;
  }
}

TEST_P(LengthsTest, AreInMillimetresInASmallOne) {
  for (const ShownLength& length : lengthsOf("nut-and-bolt")) {
    const std::string text = length.text.toStdString();
    if (isOfCurve(length)) continue;
    EXPECT_LE(length.decimals, 5) << text;
    EXPECT_NE(length.unit, QStringLiteral("m")) << text;
    EXPECT_TRUE(length.unit != QStringLiteral("µm") || length.number < 10.0) << text;
  }
}

TEST_P(LengthsTest, FollowAnotherUnitAtOnce) {
  const ScriptCommands& scripts = window_->workbench().scripts;
  (void)lengthsOf("nut-and-bolt");
  EXPECT_TRUE(scripts.carryOut("action", {"fits.find"}).ok());
  EXPECT_TRUE(scripts.carryOut("plan-sequence", {"all"}).ok());
  expectInches();
  (void)lengthsOf("environment-1");
  WorkbenchDocument& document = window_->workbench().document;
  EXPECT_TRUE(document.place({AssemblyItem::Kind::Start, {}}, document.scenario()->obstacles.front().X_WB).ok());
  EXPECT_TRUE(scripts.carryOut("action", {"run.start"}).ok());
  EXPECT_TRUE(scripts.carryOut("expect", {"failed"}).ok());
  expectInches();
}

INSTANTIATE_TEST_SUITE_P(Window, LengthsTest, testing::Values("en"));

}  // namespace
}  // namespace glissade
