#pragma once

#include <functional>
#include <memory>

#include "app/window/window_room.h"
#include "widgets/workbench/panel_docks.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class FileController;
class NamedViewsController;
class PreferencesController;
class RecordingController;
class StudyController;
class WindowMemory;

/// The window: the 3D view in the middle, panels around it, one document and one session. It makes the controllers and
/// connects them; they contain the functions.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow(const SceneWidgetFactory& makeScene, SessionClock clock);
  ~MainWindow() override;

  /// The objects that scripts and the command line use.
  const Workbench& workbench() const { return bench_; }
  /// Opens a scenario, or shows a run of a study again; errors are shown in a dialog unless `quiet`, and returned.
  std::optional<Diagnostic> openScenario(const QString& file, bool quiet = false);
  /// Asks in a modal dialog how to import part files.
  void importParts(const QStringList& files);
  void setTheme(Theme theme);
  /// Limits the size of the window and arranges its panels in this room, which room() returns.
  void fitInto(const QSize& room) { room_.fit(room); }
  const QSize& room() const { return room_.room(); }
  /// Whether the window was closed to be shown again without a scenario. A document never becomes empty again.
  bool closesToWelcomePage() const { return closesToWelcomePage_; }
  /// No person answers questions: scripts, screenshots.
  void setBatch(bool batch);
  /// Remembers recent files and the layout from now on, and restores the remembered layout.
  void remember(std::unique_ptr<WindowMemory> memory, bool sizeToo);
  /// Writes unsaved edits into the folder from now on, and offers to restore those of killed programs.
  void keepUnsavedEdits(const QString& folder);
  /// Journals runs in the folder, and offers to save the runs of killed programs.
  void keepJournals(const QString& folder);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void addParts();
  void connectActions();

  std::unique_ptr<SceneWidget> scene_;
  ActionCatalogue& actions_;
  ScriptCommands scripts_;
  Messages messages_;
  FileDialogs dialogs_;
  WorkbenchDocument* document_;
  SessionBridge* session_;
  Workbench bench_;
  PanelDocks docks_;
  WindowRoom room_;
  FileController* files_ = nullptr;
  NamedViewsController* views_ = nullptr;
  RecordingController* recordings_ = nullptr;
  StudyController* studies_ = nullptr;
  PreferencesController* preferences_ = nullptr;
  std::function<void()> remember_;  ///< gives the controllers the contents of memory_ before the layout is restored
  QWidget* replayBar_ = nullptr;
  bool closesToWelcomePage_ = false;
  std::unique_ptr<WindowMemory> memory_;  ///< null: the window remembers nothing
};

}  // namespace glissade
