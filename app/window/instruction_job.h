#pragma once

#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <vector>

#include "app/window/workbench.h"
#include "engine/base/file_save.h"
#include "engine/study/work_instruction.h"
#include "widgets/bridge/sequence_planner.h"

namespace glissade {

class SequenceController;

/// Makes the work instruction of the plan that is shown, as HTML or PDF. Views are chosen and the file is written in
/// the background; pictures are taken in the 3D view, one at each turn of the event loop, and the camera is as before
/// afterwards. In scripts all of it is done at once.
class InstructionJob final : public QObject {
  Q_OBJECT

 public:
  InstructionJob(const Workbench& bench, SequenceController& sequence);

  using Finished = std::function<void(const SaveResult&)>;
  /// A job that is under way ends without its file. Errors: those of writing; Usage where the plan has changed
  /// meanwhile.
  void start(const QString& file, Finished finished);

 private:
  /// What the file is made of; read by the worker, which is the only one then.
  struct Content {
    PlanPtr plan;
    ProductPtr product;
    std::vector<StepCheck> checks;
    std::string name;
    double deviation = 0.0;
    WorkTimes times;
    QString file;
    QTemporaryDir folder;
    std::vector<Vector3> toEye;  ///< of each step
    std::string exploded;
    std::vector<std::string> pictures;
  };

  void chooseViews();
  void takePictures();
  SaveResult takeNextPicture();
  SaveResult takePicture(const QString& name, std::string& file);
  void write();
  void end(const SaveResult& result);

  const Workbench& bench_;
  SequenceController& sequence_;
  std::shared_ptr<Content> content_;
  Finished finished_;
};

}  // namespace glissade
