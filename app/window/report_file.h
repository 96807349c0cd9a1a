#pragma once

#include <QSize>
#include <QString>

#include "engine/base/file_save.h"
#include "engine/study/study_report.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Writes a report as PDF where the file's name ends so, else as HTML.
SaveResult saveReport(const StudyReport& report, const QString& file);

/// Pixels of a picture on a page of a report.
inline constexpr QSize kPagePicture(960, 600);

/// The scene as it is seen, as a PNG of that size.
SaveResult saveScenePicture(SceneWidget& scene, const QString& file);

}  // namespace glissade
