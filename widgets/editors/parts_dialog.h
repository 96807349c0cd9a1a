#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <optional>
#include <vector>

#include "engine/scenario/part_files.h"
#include "engine/scenario/unit_guess.h"
#include "widgets/bridge/background_task.h"

namespace glissade {

/// Asks by how much triangles may be off the surfaces of STEP files; at first by the size of each part.
class FinenessBox final : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit FinenessBox(QWidget* parent = nullptr);

  /// 0: by the size of each part.
  double metres() const { return value() / 1e3; }
};

/// Names of part files, as file dialogs want them.
QString partFilePatterns();

/// Asks how the files of a product's parts are to be taken, and which part moves. Files are measured in
/// the background, so that a wrong unit is seen at once; the parts of a STEP file become rows of their own.
class PartsDialog final : public QDialog {
  Q_OBJECT

 public:
  enum class Purpose { NewScenario, AddParts };
  enum Column { kPart, kRole, kUnit, kUp, kSize };

  /// `atOnce`: files are measured before the constructor and addFiles() return.
  PartsDialog(Purpose purpose, const QStringList& files, bool atOnce, QWidget* parent = nullptr);

  /// Where the dialog that adds files begins while none is listed.
  void setFolder(const QString& folder) { folder_ = folder; }
  /// Files that are listed already stay as they are.
  void addFiles(const QStringList& files);

  std::vector<PartFile> parts() const;
  /// What was read to measure them, and need not be read again.
  const GeometryCache& read() const { return read_; }
  /// All files were read, and one part moves where one has to.
  bool isComplete() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    PartFile part;
    std::optional<Result<Box3>> inFile;  ///< none: not measured yet
    bool unitChosen = false;             ///< by a person
  };

  void setUpTable();
  void fillTable();
  QString nameOf(const PartFile& part) const;
  void makeRow(int row);
  void makeBoxes(int row);
  void makeBoxesInSight();
  QLayout* makeFileButtons();
  QWidget* makeButtons();
  QComboBox* makeRole(const QString& name);
  QComboBox* makeUnit(const QString& name);
  QComboBox* makeUp(const QString& name);
  void takeApart(bool wanted);
  void chooseFiles();
  void removeSelected();
  void chooseRole(int row, PartRole role);
  std::vector<int> rowsWith(int row) const;
  int rowOf(const QObject* combo, Column column) const;
  int rowOf(const std::string& path) const;

  using Measured = Result<std::vector<MeasuredPart>>;
  void measureNext();
  std::vector<std::string> filesToMeasure() const;
  void setMeasured(const std::string& path, const Measured& measured);
  bool isMeasured() const;
  bool hasMoving() const;
  void guessUnits();
  void guessWhatMoves();
  void refresh();
  void showRow(int row);
  void showSize(int row);
  QString hint() const;

  Purpose purpose_;
  bool atOnce_;
  QString folder_;
  bool roleChosen_ = false;
  std::vector<Row> rows_;               ///< as in the table
  std::optional<UnitGuess> unitGuess_;  ///< of the files that say none, where nobody has chosen
  GeometryCache read_;
  QTableWidget* table_;
  QPushButton* remove_;
  QCheckBox* closeHoles_;
  QCheckBox* apart_;  ///< groups of OBJ files and solids of CAD parts are parts
  FinenessBox* fineness_;
  QLabel* hint_;
  QPushButton* accept_ = nullptr;
  BackgroundTask measuring_;
  std::vector<std::string> measuredPaths_;  ///< of the files that measuring_ reads
};

}  // namespace glissade
