#pragma once

#include <QSize>
#include <QString>

#include "engine/base/file_save.h"
#include "engine/documents/report.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Writes a report as PDF if the file's name ends with .pdf, else as HTML.
SaveResult saveReport(const Report& report, const QString& file);

/// Size of a picture on a page of a report, pixels.
inline constexpr QSize kPagePicture(960, 600);

/// Writes the scene with the present camera as a PNG of the size kPagePicture.
SaveResult saveScenePicture(SceneWidget& scene, const QString& file);

}  // namespace glissade
