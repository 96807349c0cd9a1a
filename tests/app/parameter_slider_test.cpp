#include "widgets/panels/parameter_slider.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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
