#pragma once

#include <functional>
#include <memory>

#include "app/window/workbench.h"
#include "engine/sweep/swept_volume.h"

namespace glissade {

/// The swept volume of the path that is shown: computed in the background, drawn in the scene, written into files.
class SweepController final : public QObject {
  Q_OBJECT

 public:
  explicit SweepController(const Workbench& bench);

 private:
  /// A swept volume, and what lies within it.
  struct Shown {
    std::shared_ptr<const Path> path;
    std::shared_ptr<const SweptVolume> sweep;
    QStringList bodies;
  };

  void addCommands();
  /// Of the run, or of the replay that is shown; may be null.
  std::shared_ptr<const Path> path() const;
  /// Another path has no swept volume yet.
  void followPath();
  /// Computes the swept volume where there is none yet, then calls `then`.
  void compute(const std::function<void()>& then);
  void show(bool shown);
  void tell();
  void chooseExport();
  Outcome exportTo(const QString& file);
  void enableActions();

  const Workbench& bench_;
  std::shared_ptr<const Path> followed_;  ///< the last one that was there
  Shown shown_;
};

}  // namespace glissade
