#include "widgets/controls/action_catalogue.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QSet>
#include <utility>
#include <vector>

#include "app/window/icons.h"
#include "app/window/window_actions.h"

namespace glissade {
namespace {

TEST(ActionCatalogue, IdsAndShortcutsAreUniqueAndEveryActionExplainsItself) {
  ActionCatalogue catalogue(windowActions(), nullptr);
  QSet<QString> ids;
  QSet<QString> shortcuts;
  for (const ActionSpec& spec : catalogue.specs()) {
    const QString id = QLatin1String(spec.id);
    EXPECT_FALSE(ids.contains(id)) << spec.id;
    ids.insert(id);
    const QAction* action = catalogue.find(id);
    ASSERT_NE(action, nullptr);
    EXPECT_FALSE(action->text().isEmpty()) << spec.id;
    EXPECT_FALSE(action->toolTip().isEmpty()) << spec.id;
    const QString keys = action->shortcut().toString();
    EXPECT_EQ(keys.isEmpty(), spec.key[0] == '\0') << spec.id << " has an unreadable shortcut";
    if (keys.isEmpty()) continue;
    EXPECT_FALSE(shortcuts.contains(keys)) << spec.id << " repeats " << keys.toStdString();
    shortcuts.insert(keys);
    EXPECT_TRUE(action->toolTip().contains(action->shortcut().toString(QKeySequence::NativeText))) << spec.id;
  }
  EXPECT_EQ(catalogue.find(QStringLiteral("no.such")), nullptr);
}

TEST(ActionCatalogue, EveryIconHasAnActionAndIsDrawn) {
  const ActionCatalogue catalogue(windowActions(), nullptr);
  applyIcons(catalogue, Qt::blue);
  const QStringList files = QDir(QStringLiteral(":/icons")).entryList();
  EXPECT_GT(files.size(), 40);
  for (const QString& file : files) {
    const QAction* action = catalogue.find(file.left(file.size() - 4));
    ASSERT_NE(action, nullptr) << file.toStdString() << " has the name of no action";
    const QImage picture = action->icon().pixmap(48, 48).toImage();
    int drawn = 0;
    for (int x = 0; x < picture.width(); ++x) {
      for (int y = 0; y < picture.height(); ++y) drawn += qAlpha(picture.pixel(x, y)) > 128 ? 1 : 0;
    }
    EXPECT_GT(drawn, 60) << file.toStdString();
    EXPECT_EQ(picture.pixelColor(0, 0).alpha(), 0) << file.toStdString() << " has a background";
  }
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
  ActionCatalogue catalogue(windowActions(), nullptr);
  for (const auto& [id, keys] : common) {
    const QAction* action = catalogue.find(QLatin1String(id));
    ASSERT_NE(action, nullptr) << id;
    EXPECT_EQ(action->shortcut().toString().toStdString(), keys) << id;
  }
}

}  // namespace
}  // namespace glissade
