#pragma once

#include <QFileDialog>

#include "engine/files/path_exporter.h"

namespace glissade {

/// The endings of a format's files as a dialog's filter needs them, "*.csv".
QString patternsOf(const PathExporter& format);

/// Asks where to export the path. It has a filter for each format of the registry; a name without an ending gets the
/// ending of the chosen filter.
class ExportDialog : public QFileDialog {
  Q_OBJECT
 public:
  /// Precondition: the registry has a format.
  explicit ExportDialog(const PathExporterRegistry& registry, QWidget* parent = nullptr);

  /// Proposes the name of the file, without its ending.
  void propose(const QString& stem);
};

}  // namespace glissade
