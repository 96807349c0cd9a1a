#pragma once

#include <optional>

#include "widgets/files/file_controller.h"
#include "widgets/files/welcome_page.h"
#include "widgets/workbench/scenario_pictures.h"

namespace glissade {

/// The welcome page over the empty scene, and the pictures of recent files, which are taken when a scenario is saved or
/// closed. In scripts and pictures it has only samples.
class WelcomeController final : public QObject {
  Q_OBJECT

 public:
  WelcomeController(const Workbench& bench, FileController& files);

 private:
  void showRecent();
  void takePicture(const QString& file);
  void addCommands();
  Outcome openSample(const std::string& name);

  const Workbench& bench_;
  FileController& files_;
  WelcomePage* page_;
  QString samples_;  ///< folder of the samples; empty: none
  ScenarioPictures pictures_;
};

}  // namespace glissade
