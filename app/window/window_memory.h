#pragma once

#include <QMainWindow>
#include <QSettings>
#include <QStringList>

#include "app/window/named_views.h"
#include "app/window/preferences.h"
#include "app/window/stereo_settings.h"
#include "engine/planning/path_spacing.h"
#include "engine/sequence/work_times.h"
#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// What the window remembers from one start to the next: the files opened last, the folders of its dialogs, where its
/// panels lie, and a user's choices: ghosts along paths, the table of work times, the template of work instructions,
/// language, size of texts, unit of lengths, colours, theme, navigation, perspective, stereo, shortcuts. Kept as the
/// platform keeps settings. Scripts and pictures have none.
class WindowMemory {
 public:
  /// The user's own.
  WindowMemory();
  /// A file of one's own, for tests.
  explicit WindowMemory(const QString& file);

  /// Absolute, the latest first, at most ten; they may be gone.
  QStringList recentFiles() const;
  void noteFile(const QString& file);
  void forgetFiles();

  void saveLayout(const QMainWindow& window);
  /// Nothing happens where no layout of this version was saved. `sizeToo`: and place on the screen.
  void restoreLayout(QMainWindow& window, bool sizeToo) const;

  /// The folder that was used last for a purpose, by its word; empty: none.
  QString folder(const QString& purpose) const;
  void noteFolder(const QString& purpose, const QString& folder);
  /// The views that have a name, of this scenario file.
  NamedViews views(const QString& file) const;
  void saveViews(const QString& file, const NamedViews& views);

  /// Where the object is drawn along paths.
  PathSpacing ghosts() const;
  void saveGhosts(const PathSpacing& spacing);

  /// A value that its row does not take is the default.
  WorkTimes workTimes() const;
  /// Only what differs from the defaults.
  void saveWorkTimes(const WorkTimes& times);

  /// Absolute path of the template of work instructions; empty: none.
  QString instructionTemplate() const;
  void saveInstructionTemplate(const QString& file);

  /// A value that is out of its range is the default.
  StereoSettings stereo() const;
  void saveStereo(const StereoSettings& settings);

  Preferences preferences() const;
  void savePreferences(const Preferences& preferences);

  void saveChoices(const ActionCatalogue& actions);
  /// Choices that were never saved stay as they are.
  void restoreChoices(ActionCatalogue& actions) const;

 private:
  ThemeChoice theme() const;

  QSettings settings_;
};

}  // namespace glissade
