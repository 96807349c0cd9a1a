#include "app/window/earlier_versions_menu.h"

#include <QDateTime>
#include <QLocale>

#include "engine/base/file_versions.h"

namespace glissade {

EarlierVersionsMenu::EarlierVersionsMenu(std::function<QString()> openFile, QWidget* parent)
    : QMenu(tr("Earlier &versions"), parent), openFile_(std::move(openFile)) {
  setObjectName(QStringLiteral("menu.versions"));
  connect(this, &QMenu::aboutToShow, this, &EarlierVersionsMenu::fill);
}

void EarlierVersionsMenu::fill() {
  clear();
  const QString file = openFile_();
  const auto versions = file.isEmpty() ? std::vector<FileVersion>() : earlierVersions(file.toStdString());
  for (const FileVersion& version : versions) {
    const QString time = QLocale().toString(QDateTime::fromSecsSinceEpoch(version.time), QLocale::ShortFormat);
    QAction* action = addAction(tr("Version %1, saved %2").arg(version.number).arg(time));
    connect(action, &QAction::triggered, this,
            [this, path = QString::fromStdString(version.path)] { emit chosen(path); });
  }
  if (versions.empty()) addAction(tr("No earlier version yet"))->setEnabled(false);
}

}  // namespace glissade
