#pragma once

#include <functional>
#include <memory>

#include "app/window/panel_docks.h"
#include "app/window/window_room.h"
#include "app/window/workbench.h"

namespace glissade {

class FileController;
class NamedViewsController;
class PreferencesController;
class RecordingController;
class WindowMemory;

/// The workbench: the 3D view in the middle, panels around it, one document and one session behind it. It makes the
/// parts and brings them together; what they do is theirs.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow(const SceneWidgetFactory& makeScene, SessionClock clock);
  ~MainWindow() override;

  /// What scripts and the command line work with.
  const Workbench& workbench() const { return bench_; }
  /// Opens a scenario; errors are shown in a dialog unless `quiet`, and returned.
  std::optional<Diagnostic> openScenario(const QString& file, bool quiet = false);
  /// Asks how part files are to be taken, in a dialog that it waits for.
  void importParts(const QStringList& files);
  void setTheme(Theme theme);
  /// The window is at most so large, and its panels are arranged so that they have room in it.
  void fitInto(const QSize& room) { room_.fit(room); }
  /// What fitInto() was called with.
  const QSize& room() const { return room_.room(); }
  /// Nobody is there to answer questions: scripts, screenshots.
  void setBatch(bool batch);
  /// From now on recent files and the layout are remembered; the layout comes back as it was left.
  void remember(std::unique_ptr<WindowMemory> memory, bool sizeToo);
  /// Writes unsaved edits into the folder from now on, and offers what killed programs have left there.
  void keepUnsavedEdits(const QString& folder);
  /// Journals runs in the folder, and offers to save what killed programs have left there.
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
  PreferencesController* preferences_ = nullptr;
  std::function<void()> remember_;  ///< lets parts take what memory_ has, before the layout comes back
  QWidget* replayBar_ = nullptr;
  std::unique_ptr<WindowMemory> memory_;  ///< null: nothing is remembered
};

}  // namespace glissade
