#pragma once

#include <QSettings>
#include <QStringList>

#include "engine/planning/path_spacing.h"
#include "engine/sequence/work_times.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/workbench/named_views.h"
#include "widgets/workbench/panel_docks.h"
#include "widgets/workbench/preferences.h"
#include "widgets/workbench/stereo_settings.h"

namespace glissade {

/// The data that the window keeps between sessions: recent files, folders of dialogs, places of panels, and a user's
/// choices: ghosts along paths, the table of work times, the template of work instructions, language, size of texts,
/// unit of lengths, colours, theme, navigation, perspective, stereo, shortcuts. They are kept in the platform's
/// settings. Scripts and pictures have no memory.
class WindowMemory {
 public:
  /// Opens the user's settings.
  WindowMemory();
  /// Opens settings in this file, for tests.
  explicit WindowMemory(const QString& file);

  /// Absolute names, the latest first, at most ten; the files may be gone.
  QStringList recentFiles() const;
  void noteFile(const QString& file);
  void forgetFiles();

  /// Size and place of the window on the screen; empty: none was saved.
  QByteArray windowGeometry() const;
  /// The layouts of the workspaces that were shown.
  PanelDocks::Layouts layouts() const;
  void saveLayouts(const PanelDocks::Layouts& layouts, const QByteArray& geometry);

  /// The last folder of a purpose, by its key; empty: none.
  QString folder(const QString& purpose) const;
  void noteFolder(const QString& purpose, const QString& folder);
  /// The named views of this scenario file.
  NamedViews views(const QString& file) const;
  void saveViews(const QString& file, const NamedViews& views);

  /// Spacing of the object's ghosts along paths.
  PathSpacing ghosts() const;
  void saveGhosts(const PathSpacing& spacing);

  /// The table of work times. A value out of its row's range is replaced by the default.
  WorkTimes workTimes() const;
  /// Saves the values that differ from the defaults.
  void saveWorkTimes(const WorkTimes& times);

  /// Absolute path of the template of work instructions; empty: none.
  QString instructionTemplate() const;
  void saveInstructionTemplate(const QString& file);

  /// The settings of stereo. A value out of its range is replaced by the default.
  StereoSettings stereo() const;
  void saveStereo(const StereoSettings& settings);

  Preferences preferences() const;
  void savePreferences(const Preferences& preferences);

  void saveChoices(const ActionCatalogue& actions);
  /// Restores the saved choices; others do not change.
  void restoreChoices(ActionCatalogue& actions) const;

 private:
  ThemeChoice theme() const;

  QSettings settings_;
};

}  // namespace glissade
