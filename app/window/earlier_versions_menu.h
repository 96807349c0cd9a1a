#pragma once

#include <QMenu>

#include <functional>

namespace glissade {

/// The menu of the earlier versions of the file that is open (engine/base/file_versions.h), the latest first.
class EarlierVersionsMenu final : public QMenu {
  Q_OBJECT

 public:
  /// `openFile` is empty where no file is open.
  EarlierVersionsMenu(std::function<QString()> openFile, QWidget* parent);

 signals:
  /// The user wants the content of this file in place of what is open.
  void chosen(const QString& versionFile);

 private:
  void fill();

  std::function<QString()> openFile_;
};

}  // namespace glissade
