#pragma once

#include <QObject>
#include <optional>

#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/path_panel.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// The path that was found or given: shown, played, smoothed, read from files and written into them. Part of the
/// main window.
class PathController final : public QObject {
  Q_OBJECT

 public:
  PathController(SessionBridge& bridge, const ActionCatalogue& actions, SceneWidget& scene, QWidget* window);

  PathPanel* panel() const { return panel_; }
  /// `live`: not of a replay.
  void showSnapshot(const SnapshotPtr& snapshot, const ScenarioPtr& scenario, bool live);
  /// Reads a path of the open scenario, which is then examined; nothing on success.
  std::optional<Diagnostic> open(const QString& file);

  /// Saves the path in the format of the file's ending; nothing on success.
  std::optional<Diagnostic> exportTo(const QString& file);
  /// "none", "certified", or the id of the body that blocks it first ("-": its ends do not fit, or none is near).
  std::string verdict() const;

 signals:
  /// There is something to see in the panel.
  void found();
  /// What was done, where it is not seen.
  void told(const QString& text);
  void failed(const glissade::Diagnostic& why);

 private:
  void connectActions();
  void chooseFile();
  void chooseExport();
  void enableActions();

  SessionBridge& bridge_;
  const ActionCatalogue& actions_;
  PathPanel* panel_;
  ScenarioPtr scenario_;
  SnapshotPtr snapshot_;
  bool live_ = false;  ///< snapshot_ is of the session, not of a replay
};

}  // namespace glissade
