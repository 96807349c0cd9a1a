#pragma once

#include <QLabel>
#include <QMainWindow>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/scenario/run_record.h"
#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

class AssemblyController;
class BodyVisibility;
class CountsPanel;
class DeviceController;
class DifficultyController;
class EnvironmentController;
class InteractionPanel;
class PartImport;
class PathController;
class ReplayController;
class StudyController;
class WindowMemory;
class WorkController;

/// The workbench: the 3D view in the middle, panels around it, one session behind it.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow(const SceneWidgetFactory& makeScene, SessionClock clock);
  ~MainWindow() override;

  /// Opens a scenario; says what is wrong in a dialog unless `quiet`, and returns it.
  std::optional<Diagnostic> openScenario(const QString& file, bool quiet = false);
  /// The same without waiting for it: reading STEP files takes its time. Cancelled as all background work.
  void openInBackground(const QString& file);
  void setTheme(Theme theme);
  /// Nobody is there to answer questions: scripts, screenshots.
  void setBatch(bool batch);

  SessionBridge& bridge() { return *bridge_; }
  ActionCatalogue& actions() { return *actions_; }
  SceneWidget& scene() { return *scene_; }
  EnvironmentController& environment() { return *environment_; }
  StudyController& studies() { return *studies_; }
  DeviceController& devices() { return *devices_; }
  ReplayController& replay() { return *replay_; }
  BodyVisibility& bodies() { return *bodies_; }
  AssemblyController& assembly() { return *assembly_; }
  PartImport& parts() { return *parts_; }
  DifficultyController& difficulty() { return *difficulty_; }
  PathController& path() { return *path_; }
  WorkController& work() { return *work_; }
  /// Replays what was read from a file, and opens its scenario where another is open; says what is wrong
  /// in a dialog unless `quiet`, and returns it.
  std::optional<Diagnostic> openRecording(const Result<RunRecord>& record, const QString& file, bool quiet = false);
  /// From now on recent files and the layout are remembered; the layout comes back as it was left.
  void remember(std::unique_ptr<WindowMemory> memory, bool sizeToo);
  /// Journals runs in the folder, and offers to save what killed programs have left there.
  void keepJournals(const QString& folder);
  /// Saves the scenario with edits, strategy, seed and parameters as they are; from then on it is that
  /// file's. Assets stay where they are and are named as seen from there. Nothing on success.
  std::optional<Diagnostic> saveScenarioAs(const QString& file);
  /// In a dialog.
  void showError(const QString& title, const Diagnostic& why);
  /// The whole window as a picture.
  /// The whole window as a picture, with the dialogs that lie over it.
  QImage picture();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  std::optional<Diagnostic> takeScenario(Result<LoadedScenario> loaded, const QString& file, bool quiet);
  void makePanels();
  void arrangePanels();
  void makeMenus();
  void fillRecent();
  void connectPanels();
  void connectActions();
  void connectViewActions();
  /// Panels of fixed rows are scrolled as a whole; those with lists scroll these.
  enum class Scrolling { Whole, Own };
  /// `action` brings it to the front.
  void addPanel(const QString& title, const char* id, QWidget* content, const char* action = "",
                Scrolling scrolling = Scrolling::Whole);
  void openLoaded(const ScenarioPtr& scenario);
  /// Shows the rules of the strategy; changed, they become the scenario's own.
  void editRules();
  void newScenario(const QStringList& partFiles);
  /// The open scenario with its bodies elsewhere, or others; what is looked at and what was set stay.
  void rearrange(const ScenarioPtr& scenario);
  void showSnapshot(const SnapshotPtr& snapshot);
  void enableActions(const SessionSnapshot* snapshot);
  void publishOperatorFrame();
  void restart(std::uint64_t seed);
  void chooseScenario();
  void chooseRecording();
  void chooseSaveRecording();
  /// Where the user wants it; empty where he does not.
  QString offerJournal(const QString& file);
  /// A journal, and the recording that it is to become.
  using JournalSave = std::pair<QString, QString>;
  void saveJournals(const std::vector<JournalSave>& saves);
  void save();
  void chooseSave();
  /// False: the user wants to stay, because something is not saved.
  bool mayDiscard();
  /// What Save would write is not what the file holds. Sliders and seed are tried out, and do not count.
  bool isModified() const;
  void showTitle();
  void showShortcuts();
  void showAbout();

  ActionCatalogue* actions_;
  SessionBridge* bridge_;
  std::unique_ptr<SceneWidget> scene_;
  InteractionPanel* interaction_ = nullptr;
  CountsPanel* counts_ = nullptr;
  PathController* path_ = nullptr;
  AssemblyController* assembly_ = nullptr;
  PartImport* parts_ = nullptr;
  BodyVisibility* bodies_ = nullptr;
  EnvironmentController* environment_ = nullptr;
  StudyController* studies_ = nullptr;
  DeviceController* devices_ = nullptr;
  ReplayController* replay_ = nullptr;
  WorkController* work_ = nullptr;
  DifficultyController* difficulty_ = nullptr;
  std::unique_ptr<WindowMemory> memory_;  ///< null: nothing is remembered
  QMenu* recent_ = nullptr;
  bool batch_ = false;  ///< nobody is there to be asked
  QLabel* status_;
  QLabel* elapsed_;
  QLabel* welcome_;
  ScenarioPtr scenario_;
  SnapshotPtr snapshot_;
};

}  // namespace glissade
