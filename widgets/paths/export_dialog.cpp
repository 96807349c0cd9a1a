#include "widgets/paths/export_dialog.h"

#include "widgets/controls/diagnostic_text.h"

namespace glissade {

QString patternsOf(const PathExporter& format) {
  QStringList patterns;
  for (const std::string& ending : format.endings) patterns << QStringLiteral("*.") + QString::fromStdString(ending);
  return patterns.join(QLatin1Char(' '));
}

ExportDialog::ExportDialog(const PathExporterRegistry& registry, QWidget* parent)
    : QFileDialog(parent, tr("Export the path")) {
  setAcceptMode(AcceptSave);
  QStringList filters;
  for (const PathExporter& exporter : registry.entries()) {
    const QString label = engineText(exporter.label);
    filters << QStringLiteral("%1 (%2)").arg(label, patternsOf(exporter));
  }
  setNameFilters(filters);
  const auto takeEndingOf = [this, filters, entries = registry.entries()](const QString& filter) {
    const int chosen = filters.indexOf(filter);
    if (chosen < 0) return;
    setDefaultSuffix(QString::fromStdString(entries[static_cast<std::size_t>(chosen)].endings.front()));
  };
  connect(this, &QFileDialog::filterSelected, this, takeEndingOf);
  takeEndingOf(filters.front());
  propose(QStringLiteral("path"));
}

void ExportDialog::propose(const QString& stem) { selectFile(stem + QLatin1Char('.') + defaultSuffix()); }

}  // namespace glissade
