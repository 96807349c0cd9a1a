#include "widgets/workbench/proposed_file.h"

#include "engine/files/product_name.h"

namespace glissade {

QString proposedFile(const LoadedScenario& scenario, const QString& what) {
  QString name = QString::fromStdString(nameOfProduct(scenario));
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
  if (what.startsWith(QLatin1Char('.'))) return (name.isEmpty() ? QStringLiteral("scenario") : name) + what;
  return name.isEmpty() ? what : name + QLatin1Char('-') + what;
}

}  // namespace glissade
