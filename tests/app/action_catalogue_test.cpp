#include "widgets/commands/action_catalogue.h"

#include <gtest/gtest.h>

#include <QSet>

namespace glissade {
namespace {

TEST(ActionCatalogue, IdsAndShortcutsAreUniqueAndEveryActionExplainsItself) {
  ActionCatalogue catalogue(nullptr);
  QSet<QString> ids;
  QSet<QString> shortcuts;
  for (const ActionSpec& spec : actionSpecs()) {
    const QString id = QLatin1String(spec.id);
    EXPECT_FALSE(ids.contains(id)) << spec.id;
    ids.insert(id);
    const QAction* action = catalogue.find(id);
    ASSERT_NE(action, nullptr);
    EXPECT_FALSE(action->text().isEmpty()) << spec.id;
    EXPECT_FALSE(action->toolTip().isEmpty()) << spec.id;
    const QString keys = action->shortcut().toString();
    EXPECT_EQ(keys.isEmpty(), spec.shortcut[0] == '\0') << spec.id << " has an unreadable shortcut";
    if (keys.isEmpty()) continue;
    EXPECT_FALSE(shortcuts.contains(keys)) << spec.id << " repeats " << keys.toStdString();
    shortcuts.insert(keys);
    EXPECT_TRUE(action->toolTip().contains(action->shortcut().toString(QKeySequence::NativeText))) << spec.id;
  }
  EXPECT_EQ(catalogue.find(QStringLiteral("no.such")), nullptr);
}

}  // namespace
}  // namespace glissade
