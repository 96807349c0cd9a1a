#include "widgets/controls/parameter_slider.h"

#include <gtest/gtest.h>

#include <QLayout>
#include <QLineEdit>

#include <cmath>
#include <vector>

#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

TEST(ParameterSlider, ShowsEveryLiveParameterAndGivesBackWhatItShows) {
  for (const ParameterSpec& spec : parameterTable()) {
    if (!spec.live) continue;
    ParameterSlider slider(spec.id);
    slider.setObjectRadius(1.536);
    const ParameterRange range = rangeOf(spec.id, 1.536);
    for (const double share : {0.0, 0.3, 1.0}) {
      double value = range.minimum + share * (range.maximum - range.minimum);
      if (spec.integer) value = std::round(value);
      slider.setValue(value);
      EXPECT_NEAR(slider.value(), value, 1e-3 * (range.maximum - range.minimum)) << spec.key;
    }
    EXPECT_FALSE(slider.toolTip().isEmpty()) << spec.key;
  }
}

/// The digits depend on the length in metres, not on the number of radii.
TEST(ParameterSlider, AFieldHasTheDigitsThatTheSizeOfTheObjectNeeds) {
  ParameterSlider distance(ParameterId::ContactDistance);
  distance.setObjectRadius(0.002);
  distance.setValue(0.000134);  // the default is 0.2 mm
  EXPECT_NEAR(distance.value(), 0.000134, 1e-9);
  distance.setObjectRadius(1.5);
  distance.setValue(0.1234);
  EXPECT_NEAR(distance.value(), 0.1234, 1e-9);
  ParameterSlider clearance(ParameterId::RequiredClearance);
  for (const double radius : {0.01, 1.5, 50.0}) {
    clearance.setObjectRadius(radius);
    clearance.setValue(5e-5);
    EXPECT_NEAR(clearance.value(), 5e-5, 1e-9) << radius;
  }
}

TEST(ParameterSlider, DraggingAndTypingAnnounceValuesThatTheTableAccepts) {
  for (const ParameterSpec& spec : parameterTable()) {
    if (!spec.live) continue;
    ParameterSlider slider(spec.id);
    slider.setObjectRadius(0.01);
    ParameterValues values(0.01);
    int announced = 0;
    QObject::connect(&slider, &ParameterSlider::valueChosen, [&](double value) {
      ++announced;
      EXPECT_TRUE(values.set(spec.id, value)) << spec.key << " " << value;
    });
    auto* bar = slider.findChild<QSlider*>();
    for (const int position : {1, 250, 999}) bar->setValue(position);
    slider.findChild<QDoubleSpinBox*>()->stepUp();
    EXPECT_GE(announced, 3) << spec.key;
  }
}

/// A number in inches has more digits than one in millimetres.
TEST(ParameterSlider, EveryNumberFitsItsFieldInEveryUnit) {
  for (const LengthUnit unit : {LengthUnit::Millimetres, LengthUnit::Inches, LengthUnit::Metres}) {
    for (const ParameterSpec& spec : parameterTable()) {
      if (!spec.live) continue;
      ParameterSlider slider(spec.id);
      slider.show();
      setLengthUnit(unit);
      announceLengthUnit();
      for (const double radius : {0.01, 1.5}) {
        slider.setObjectRadius(radius);
        slider.resize(300, slider.sizeHint().height());
        slider.layout()->activate();
        const auto* number = slider.findChild<QDoubleSpinBox*>();
        const auto* text = number->findChild<QLineEdit*>();
        for (const double share : {0.0, 1.0}) {
          const ParameterRange range = rangeOf(spec.id, radius);
          slider.setValue(range.minimum + share * (range.maximum - range.minimum));
          EXPECT_LE(text->fontMetrics().horizontalAdvance(text->text()), text->contentsRect().width())
              << spec.key << " " << text->text().toStdString();
        }
      }
    }
  }
  setLengthUnit(LengthUnit::Millimetres);
  announceLengthUnit();
}

TEST(ParameterSlider, SettingAValueAnnouncesNothing) {
  ParameterSlider slider(ParameterId::Alpha);
  bool announced = false;
  QObject::connect(&slider, &ParameterSlider::valueChosen, [&](double) { announced = true; });
  slider.setValue(0.7);
  EXPECT_FALSE(announced);
}

TEST(ParameterSlider, WhatSetsItselfShowsItAndIsGivenAndTakenByItsButton) {
  ParameterSlider slider(ParameterId::ContactDistance);
  slider.setObjectRadius(1.0);
  std::vector<bool> chosen;
  QObject::connect(&slider, &ParameterSlider::tuningChosen, [&](bool tuned) { chosen.push_back(tuned); });
  auto* button = slider.findChild<QToolButton*>(QStringLiteral("tuning"));
  auto* bar = slider.findChild<QSlider*>();
  ASSERT_NE(button, nullptr);
  const QColor usual = bar->palette().color(QPalette::Highlight);
  slider.setTuned(true, 0.15);
  EXPECT_TRUE(button->isChecked());
  EXPECT_NE(bar->palette().color(QPalette::Highlight), usual);
  EXPECT_TRUE(button->toolTip().contains(QStringLiteral("150"))) << button->toolTip().toStdString();
  slider.setTuned(false, 0.15);
  EXPECT_FALSE(button->isChecked());
  EXPECT_EQ(bar->palette().color(QPalette::Highlight), usual);
  EXPECT_TRUE(chosen.empty());
  button->click();
  slider.setTuned(true, 0.15);  // the session has carried it out
  EXPECT_NE(bar->palette().color(QPalette::Highlight), usual);
  button->click();
  EXPECT_EQ(chosen, (std::vector<bool>{true, false}));
  EXPECT_EQ(ParameterSlider(ParameterId::ContactRadius).findChild<QToolButton*>(QStringLiteral("tuning")), nullptr);
}

}  // namespace
}  // namespace glissade
