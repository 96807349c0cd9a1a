#pragma once

#include <QMenu>
#include <QObject>

#include <functional>
#include <optional>
#include <string>

#include "app/window/autosave_controller.h"
#include "engine/base/file_save.h"
#include "widgets/bridge/session_bridge.h"

namespace glissade {

/// The menu of the earlier versions of the file that is open (engine/base/file_versions.h), the latest first.
class EarlierVersionsMenu final : public QMenu {
  Q_OBJECT

 public:
  /// `openFile` is empty where no file is open.
  EarlierVersionsMenu(std::function<QString()> openFile, QWidget* parent);

 signals:
  /// The user wants the content of this file in place of what is open.
  void chosen(const QString& versionFile);

 private:
  void fill();

  std::function<QString()> openFile_;
};

/// What the window does for its saves.
struct SaveHost {
  std::function<ScenarioPtr()> scenario;                        ///< the open one; null: none
  std::function<bool()> isModified;                             ///< it has edits that are not saved
  std::function<Scenario(const std::string& file)> contentFor;  ///< what a save writes into that file
  std::function<void(const ScenarioPtr&)> openModified;         ///< opens it in place of what is open, as not saved
  std::function<bool()> mayDiscard;                             ///< asks about unsaved edits
  std::function<void(const QString& title, const Diagnostic&)> showError;
};

/// Saves of the scenario: notices that somebody else has changed the file, opens earlier versions, keeps unsaved
/// edits for the case of a crash. Part of the main window.
class SaveController final : public QObject {
  Q_OBJECT

 public:
  SaveController(SaveHost host, QWidget* window);

  EarlierVersionsMenu* versionsMenu() const { return versions_; }
  /// The user has seen this content of the file (its SHA-256; empty: none): only that is replaced without asking.
  void noteContent(const std::string& file, const std::string& sha256);
  /// Replaces the file only where it holds what the user has seen, or was never seen.
  SaveResult save(const Scenario& scenario, const std::string& file);
  /// The next save of the file replaces any content; the other version is kept.
  void allowReplacing() { seen_.reset(); }
  /// Offers what killed programs have left in the folder, and writes unsaved edits there from now on.
  void keepUnsavedEdits(const QString& folder);
  /// Seconds between two writings of unsaved edits.
  void setAutosaveSeconds(int seconds) { autosave_->setInterval(seconds); }

 private:
  struct Seen {
    std::string file;
    std::string sha256;
  };

  std::optional<std::string> seenContent(const std::string& file) const;
  std::optional<UnsavedEdits> unsavedEdits() const;
  bool openEdits(const UnsavedEdits& edits);
  void openVersion(const QString& versionFile);
  bool openAs(Scenario scenario, const std::string& file);

  SaveHost host_;
  QWidget* window_;
  EarlierVersionsMenu* versions_;
  AutosaveController* autosave_;
  std::optional<Seen> seen_;
};

}  // namespace glissade
