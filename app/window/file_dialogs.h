#pragma once

#include <QWidget>

#include <functional>
#include <map>

namespace glissade {

class WindowMemory;

/// What a file is chosen for. Each has a folder of its own.
enum class FilePurpose { Scenario, Parts, Path, Export, Report, Film, Recording, Sequence, Times, Study };

/// The dialogs that ask for files. Each begins in the folder that was used for its purpose last, also in an earlier
/// session where the window has a memory; before that, in the folder of the scenario.
class FileDialogs final {
 public:
  /// `usualFolder` is asked where nothing is remembered of a purpose; it may be empty.
  FileDialogs(QWidget& window, std::function<QString()> usualFolder);

  /// Null: folders are remembered until the window closes.
  void setMemory(WindowMemory* memory) { memory_ = memory; }

  /// Empty where the person cancels, as of the others.
  QString open(FilePurpose purpose, const QString& title, const QString& filter, QWidget* parent = nullptr);
  QString openFolder(FilePurpose purpose, const QString& title);
  /// `name` is proposed; where it has a folder, this one is shown.
  QString save(FilePurpose purpose, const QString& title, const QString& name, const QString& filter,
               QWidget* parent = nullptr);

  QString folderOf(FilePurpose purpose) const;
  /// Of a file that was chosen without this class.
  void noteFile(FilePurpose purpose, const QString& file);

 private:
  void noteFolder(FilePurpose purpose, const QString& folder);

  QWidget& window_;
  std::function<QString()> usualFolder_;
  WindowMemory* memory_ = nullptr;
  std::map<FilePurpose, QString> folders_;  ///< of this session
};

}  // namespace glissade
