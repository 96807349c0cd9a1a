#pragma once

#include <QMenu>
#include <QObject>

#include <functional>
#include <optional>
#include <string>

#include "engine/base/file_save.h"
#include "widgets/document/session_bridge.h"
#include "widgets/files/autosave_controller.h"

namespace glissade {

/// The menu of the earlier versions of the open file (engine/base/file_versions.h), the latest first.
class EarlierVersionsMenu final : public QMenu {
  Q_OBJECT

 public:
  /// `openFile` returns an empty name if no file is open.
  EarlierVersionsMenu(std::function<QString()> openFile, QWidget* parent);

 signals:
  /// The user wants to open this earlier version.
  void chosen(const QString& versionFile);

 private:
  void fill();

  std::function<QString()> openFile_;
};

/// Functions of the window that its saves need.
struct SaveHost {
  std::function<ScenarioPtr()> scenario;                        ///< the open scenario; null: none
  std::function<bool()> isModified;                             ///< whether it has unsaved edits
  std::function<Scenario(const std::string& file)> contentFor;  ///< the content that a save writes into this file
  std::function<void(const ScenarioPtr&)> openModified;         ///< opens a scenario as an unsaved one
  std::function<bool()> mayDiscard;                             ///< asks about unsaved edits
  std::function<void(const QString& title, const Diagnostic&)> showError;
};

/// Saves the scenario: notices that another program has changed the file, opens earlier versions, keeps unsaved edits
/// for the case of a crash. It is a part of the main window.
class SaveController final : public QObject {
  Q_OBJECT

 public:
  SaveController(SaveHost host, QWidget* window);

  EarlierVersionsMenu* versionsMenu() const { return versions_; }
  /// Notes the content that the user has seen (its SHA-256; empty: none). Only this content is replaced without a
  /// question.
  void noteContent(const std::string& file, const std::string& sha256);
  /// Saves, and replaces the file only if it holds the content that the user has seen, or if no content was noted.
  SaveResult save(const Scenario& scenario, const std::string& file);
  /// Lets the next save replace any content; the other version is kept.
  void allowReplacing() { seen_.reset(); }
  /// Offers unsaved edits that killed programs have left in the folder, and writes unsaved edits there from now on.
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
