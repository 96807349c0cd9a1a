#include "widgets/controls/action_catalogue.h"

#include <gtest/gtest.h>

#include <QSet>
#include <utility>
#include <vector>

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

/// Users of such software expect these keys.
TEST(ActionCatalogue, CommonActionsHaveTheirCommonKeys) {
  const std::vector<std::pair<const char*, const char*>> common{
      {"file.new", "Ctrl+N"},     {"file.open", "Ctrl+O"},    {"file.save", "Ctrl+S"},
      {"file.export", "Ctrl+E"},  {"file.quit", "Ctrl+Q"},    {"file.save-as", "Ctrl+Shift+S"},
      {"edit.undo", "Ctrl+Z"},    {"measure.copy", "Ctrl+C"}, {"edit.redo", "Ctrl+Shift+Z"},
      {"assembly.remove", "Del"}, {"work.cancel", "Esc"},     {"edit.preferences", "Ctrl+,"},
      {"run.start", "F5"},        {"help.manual", "F1"},      {"view.full-screen", "F11"},
      {"view.fit", "Ctrl+0"}};
  ActionCatalogue catalogue(nullptr);
  for (const auto& [id, keys] : common) {
    const QAction* action = catalogue.find(QLatin1String(id));
    ASSERT_NE(action, nullptr) << id;
    EXPECT_EQ(action->shortcut().toString().toStdString(), keys) << id;
  }
}

}  // namespace
}  // namespace glissade
