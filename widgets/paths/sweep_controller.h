#pragma once

#include <functional>
#include <memory>

#include "engine/sweep/swept_volume.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The swept volume of the shown path: computes it in the background, draws it in the scene, writes it into files.
class SweepController final : public QObject {
  Q_OBJECT

 public:
  explicit SweepController(const Workbench& bench);

 private:
  /// A swept volume, and the bodies within it.
  struct Shown {
    std::shared_ptr<const Path> path;
    std::shared_ptr<const SweptVolume> sweep;
    QStringList bodies;
  };

  void addCommands();
  /// Path of the run or of the replay that is shown; may be null.
  std::shared_ptr<const Path> path() const;
  /// Removes the swept volume when the path has changed.
  void followPath();
  /// Computes the swept volume if it is unknown, then calls `then`.
  void compute(const std::function<void()>& then);
  void show(bool shown);
  void tell();
  void chooseExport();
  Outcome exportTo(const QString& file);
  void enableActions();

  const Workbench& bench_;
  std::shared_ptr<const Path> followed_;  ///< the last path
  Shown shown_;
};

}  // namespace glissade
