#include <gtest/gtest.h>

#include <QFile>

#include "engine/environment/attribute.h"
#include "engine/operator/device_registry.h"
#include "engine/planning/planner.h"
#include "engine/scenario/path_exporter.h"
#include "tests/engine/support/directories.h"
#include "widgets/panels/engine_texts.h"
#include "widgets/panels/qt_texts.h"

namespace glissade {
namespace {

TEST(Translation, NothingIsLeftUntranslated) {
  QFile file(QString::fromStdString(test::sourceDirectory() + "/resources/i18n/glissade_fr.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  EXPECT_FALSE(text.contains(QStringLiteral("type=\"unfinished\"")));
  EXPECT_FALSE(text.contains(QStringLiteral("<translation></translation>")));
  EXPECT_GT(text.count(QStringLiteral("<message>")), 150);
}

/// French dialogs once had the English "Cancel".
TEST(Translation, QtsOwnButtonsAreInFrench) {
  QFile file(QString::fromStdString(test::sourceDirectory() + "/resources/i18n/glissade_fr.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  const QString context = text.mid(text.indexOf(QStringLiteral("<name>QPlatformTheme</name>")));
  for (const char* entry : kQtTexts) {
    EXPECT_TRUE(context.contains(QStringLiteral("<source>%1</source>").arg(QLatin1String(entry)))) << entry;
  }
  EXPECT_TRUE(context.contains(QStringLiteral("<translation>Annuler</translation>")));
}

/// French menus once had "Shift+F1" and French texts "Maj+F1".
TEST(Translation, NamesOfKeysAreInFrench) {
  QFile file(QString::fromStdString(test::sourceDirectory() + "/resources/i18n/glissade_fr.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  const QString context = text.mid(text.indexOf(QStringLiteral("<name>QShortcut</name>")));
  for (const char* key : kKeyTexts) {
    EXPECT_TRUE(context.contains(QStringLiteral("<source>%1</source>").arg(QLatin1String(key)))) << key;
  }
  EXPECT_TRUE(context.contains(QStringLiteral("<translation>Maj</translation>")));
}

TEST(Translation, EveryTextOfTheEngineThatTheWindowShowsIsOnTheTranslatorsList) {
  const auto listed = [](const std::string& text) {
    for (const char* entry : kEngineTexts) {
      if (text == entry) return true;
    }
    return false;
  };
  for (const ParameterSpec& spec : parameterTable()) {
    EXPECT_TRUE(listed(std::string(spec.label))) << spec.label;
    EXPECT_TRUE(listed(std::string(spec.help))) << spec.help;
  }
  const PlannerRegistry planners = makePlannerRegistry();
  for (const PlannerEntry& entry : planners.entries()) {
    EXPECT_TRUE(listed(entry.label)) << entry.label;
    EXPECT_TRUE(listed(entry.description)) << entry.description;
  }
  const AttributeTable attributes;
  for (const AttributeDefinition& definition : attributes.definitions()) {
    EXPECT_TRUE(listed(definition.label)) << definition.label;
    EXPECT_TRUE(listed(definition.description)) << definition.description;
  }
  const PathExporterRegistry exporters = makePathExporterRegistry();
  for (const PathExporter& exporter : exporters.entries()) EXPECT_TRUE(listed(exporter.label)) << exporter.label;
  const DeviceRegistry devices = makeDeviceRegistry();
  for (const DeviceEntry& entry : devices.entries()) {
    EXPECT_TRUE(listed(entry.label)) << entry.label;
    EXPECT_TRUE(listed(entry.description)) << entry.description;
  }
}

}  // namespace
}  // namespace glissade
