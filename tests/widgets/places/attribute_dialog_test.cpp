#include "widgets/places/attribute_dialog.h"

#include <gtest/gtest.h>

#include <optional>

namespace glissade {
namespace {

class AttributeDialogTest : public testing::Test {
 protected:
  AttributeDialogTest() { dialog.show(); }

  void write(const char* line, const char* text) {
    dialog.findChild<QLineEdit*>(QLatin1String(line))->setText(QLatin1String(text));
  }
  void choose(AttributeType type) {
    auto* types = dialog.findChild<QComboBox*>(QStringLiteral("type"));
    types->setCurrentIndex(types->findData(static_cast<int>(type)));
  }
  bool accepts() {
    dialog.accept();
    return !dialog.isVisible();
  }
  std::string refusal() const { return dialog.findChild<QLabel*>(QStringLiteral("refusal"))->text().toStdString(); }

  std::optional<AttributeDefinition> added;
  AttributeDialog dialog{AttributeOwner::Place, [this](const AttributeDefinition& definition) {
                           AttributeTable table;
                           const Outcome outcome = table.add(definition);
                           if (outcome) added = definition;
                           return outcome;
                         }};
};

TEST_F(AttributeDialogTest, StaysOpenWithItsInputUntilTheNameIsSound) {
  write("name", "Very Hot");
  EXPECT_FALSE(accepts());
  EXPECT_NE(refusal().find("'Very Hot' is not a word"), std::string::npos) << refusal();
  EXPECT_EQ(dialog.findChild<QLineEdit*>(QStringLiteral("name"))->text(), QStringLiteral("Very Hot"));
  write("name", "very_hot");
  EXPECT_TRUE(accepts());
  EXPECT_EQ(added->type, AttributeType::Bool);
}

TEST_F(AttributeDialogTest, ChoicesAreTrimmedAndGivenOnce) {
  choose(AttributeType::Choice);
  write("name", "risk");
  write("choices", "low, high, low");
  EXPECT_FALSE(accepts());
  EXPECT_NE(refusal().find("'low' twice"), std::string::npos) << refusal();
  write("choices", " low, high, ");
  EXPECT_TRUE(accepts());
  EXPECT_EQ(added->choices, (std::vector<std::string>{"low", "high"}));
}

TEST_F(AttributeDialogTest, NumbersHaveARangeAndAFirstValue) {
  choose(AttributeType::Number);
  write("name", "heat");
  write("minimum", "10");
  write("maximum", "warm");
  EXPECT_FALSE(accepts());
  write("maximum", "5");
  EXPECT_FALSE(accepts());
  write("maximum", "20.5");
  EXPECT_TRUE(accepts());
  EXPECT_EQ(added->minimum, 10.0);
  EXPECT_EQ(added->maximum, 20.5);
  EXPECT_EQ(added->initial, AttributeValue(10.0));
  dialog.show();
  write("initial", "30");
  EXPECT_FALSE(accepts());
  write("initial", "12");
  EXPECT_TRUE(accepts());
  EXPECT_EQ(added->initial, AttributeValue(12.0));
}

}  // namespace
}  // namespace glissade
