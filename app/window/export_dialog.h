#pragma once

#include <QFileDialog>

#include "engine/scenario/path_exporter.h"

namespace glissade {

/// The endings of a format's files as a dialog's filter has them, "*.csv".
QString patternsOf(const PathExporter& format);

/// Asks where to export the path. Has a filter for each format of the registry; a name without an ending
/// gets that of the filter chosen.
class ExportDialog : public QFileDialog {
  Q_OBJECT
 public:
  /// Precondition: the registry has a format.
  explicit ExportDialog(const PathExporterRegistry& registry, QWidget* parent = nullptr);

  /// The name of the file, without its ending.
  void propose(const QString& stem);
};

}  // namespace glissade
