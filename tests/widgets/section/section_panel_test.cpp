#include "widgets/section/section_panel.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

class SectionPanelTest : public testing::Test {
 protected:
  SectionPanelTest() {
    panel.setExtent(Box3(Vector3(0.0, 0.0, 0.0), Vector3(0.1, 0.2, 0.3)));
    QObject::connect(&panel, &SectionPanel::changed, [this] { ++changes; });
    panel.add({Vector3::UnitX(), 0.05, false, true});
    panel.add({Vector3::UnitX(), 0.025, false, true});
    panel.add({Vector3(1.0, 1.0, 0.0).normalized(), 0.05, false, true});
  }
  template <class Widget>
  Widget* part(const char* name) {
    return panel.findChild<Widget*>(QLatin1String(name));
  }

  ActionCatalogue actions{windowActions(), nullptr};
  SectionPanel panel{actions};
  int changes = 0;
};

TEST_F(SectionPanelTest, EachSectionHasARowWithAName) {
  EXPECT_EQ(changes, 0) << "only what somebody does is announced";
  for (const char* name : {"section-x", "section-x2", "section-face"}) EXPECT_NE(part<SectionRow>(name), nullptr);
  EXPECT_EQ(panel.sections().size(), 3U);
}

TEST_F(SectionPanelTest, APlaceIsTypedInAnyUnit) {
  auto* place = part<QuantityBox>("section-x-place");
  ASSERT_NE(place, nullptr);
  place->selectAll();
  QTest::keyClicks(place, QStringLiteral("1 in"));
  QTest::keyClick(place, Qt::Key_Return);
  EXPECT_NEAR(panel.sections()[0].place, 0.0254, 1e-12);
  EXPECT_EQ(changes, 1);
  place->selectAll();
  QTest::keyClicks(place, QStringLiteral("somewhere"));
  QTest::keyClick(place, Qt::Key_Return);
  EXPECT_NEAR(panel.sections()[0].place, 0.0254, 1e-12);
}

TEST_F(SectionPanelTest, ARowIsSwitchedTurnedAndRemoved) {
  part<QCheckBox>("section-x2-on")->click();
  EXPECT_FALSE(panel.sections()[1].on);
  const auto buttons = part<SectionRow>("section-face")->findChildren<QToolButton*>();
  ASSERT_EQ(buttons.size(), 2);
  buttons[0]->click();
  EXPECT_TRUE(panel.sections()[2].otherSide);
  buttons[1]->click();
  EXPECT_EQ(panel.sections().size(), 2U);
  EXPECT_EQ(changes, 3);
  panel.clear();
  EXPECT_TRUE(panel.sections().empty());
}

}  // namespace
}  // namespace glissade
