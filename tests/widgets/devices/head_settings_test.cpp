#include "widgets/devices/head_settings.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

namespace glissade {
namespace {

class HeadSettingsTest : public testing::Test {
 protected:
  QTemporaryDir folder_;
  QString file_ = folder_.filePath(QStringLiteral("devices.conf"));
};

TEST_F(HeadSettingsTest, WhatAPersonSetIsThereAgain) {
  HeadPreferences preferences;
  preferences.shaping.axes[2] = {4, true};
  preferences.shaping.rest = {0.1, 0.2, 0.6, 0.01, 0.02, 0.03};
  preferences.shaping.restDelay = 0.2;
  preferences.port = 5555;
  preferences.fromAnywhere = true;
  HeadSettings(file_).save(preferences);
  EXPECT_EQ(HeadSettings(file_).preferences(), preferences);
}

TEST_F(HeadSettingsTest, WhatIsOutOfRangeIsTheStandard) {
  {
    QSettings settings(file_, QSettings::IniFormat);
    settings.setValue(QStringLiteral("head/port"), 700000);
    settings.setValue(QStringLiteral("head/axis-0-source"), 9);
    settings.setValue(QStringLiteral("head/delay-at-rest"), QStringLiteral("nan"));
  }
  EXPECT_EQ(HeadSettings(file_).preferences(), HeadPreferences());
}

}  // namespace
}  // namespace glissade
