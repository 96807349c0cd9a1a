#include "widgets/editors/parts_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QShortcut>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "engine/import/mesh_import.h"
#include "widgets/commands/diagnostic_text.h"

namespace glissade {
namespace {

/// Sizes of copies of one part differ by rounding.
constexpr double kSmaller = 1.0 - 1e-6;

constexpr int kWidth = 760;
constexpr int kHeight = 400;
constexpr int kGap = 4;

/// Lets the wheel scroll the table instead of changing what it happens to be over.
class CellCombo final : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

QComboBox* makeCombo(const char* id, const QString& name, const QString& tip) {
  auto* combo = new CellCombo;
  combo->setObjectName(QLatin1String(id));
  combo->setAccessibleName(name);
  combo->setToolTip(tip);
  return combo;
}

/// Room about a combo box, which has to be filled: the column is measured with it.
QWidget* makeCell(QComboBox* combo) {
  auto* cell = new QWidget;
  auto* layout = new QHBoxLayout(cell);
  layout->setContentsMargins(kGap, kGap / 2, kGap, kGap / 2);
  layout->addWidget(combo);
  return cell;
}

/// Three digits of the largest edge, in the unit that suits it.
QString sizeText(const Box3& box) {
  const Vector3 size = box.sizes();
  const bool metres = size.maxCoeff() >= 1.0;
  const Vector3 shown = metres ? size : Vector3(1e3 * size);
  const double digits = 2.0 - std::floor(std::log10(std::max(1.001 * shown.maxCoeff(), 1e-6)));
  const auto text = [decimals = static_cast<int>(std::clamp(digits, 0.0, 6.0))](double edge) {
    return QLocale().toString(edge, 'f', decimals);
  };
  return QStringLiteral("%1 × %2 × %3 %4")
      .arg(text(shown.x()), text(shown.y()), text(shown.z()), metres ? QStringLiteral("m") : QStringLiteral("mm"));
}

/// The file's folder is left to the row's tooltip.
QString reasonText(Diagnostic why) {
  why.file = QFileInfo(QString::fromStdString(why.file)).fileName().toStdString();
  return diagnosticLine(why);
}

}  // namespace

PartsDialog::PartsDialog(Purpose purpose, const QStringList& files, bool atOnce, QWidget* parent)
    : QDialog(parent),
      purpose_(purpose),
      atOnce_(atOnce),
      table_(new QTableWidget(0, 5, this)),
      remove_(new QPushButton(tr("&Remove"), this)),
      closeHoles_(new QCheckBox(tr("Close planar &holes"), this)),
      hint_(new QLabel(this)) {
  setObjectName(QStringLiteral("parts"));
  setWindowTitle(purpose == Purpose::NewScenario ? tr("New scenario from parts") : tr("Add parts"));
  setUpTable();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(table_, 1);
  layout->addLayout(makeFileButtons());
  layout->addLayout(makeEnd());
  resize(kWidth, kHeight);
  connect(&measuring_, &BackgroundTask::failed, this,
          [this](const Diagnostic& why) { setMeasured(measuredPath_, why); });
  addFiles(files);
}

void PartsDialog::setUpTable() {
  table_->setObjectName(QStringLiteral("parts-table"));
  table_->setAccessibleName(tr("Parts"));
  table_->setHorizontalHeaderLabels({tr("Part"), tr("Role"), tr("Unit"), tr("Up"), tr("Size")});
  table_->horizontalHeaderItem(kSize)->setToolTip(tr("Width × depth × height: shows whether the unit is right"));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kPart, QHeaderView::Stretch);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->verticalHeader()->setVisible(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setTabKeyNavigation(false);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
}

QLayout* PartsDialog::makeFileButtons() {
  auto* add = new QPushButton(tr("Add &files…"), this);
  add->setObjectName(QStringLiteral("add-files"));
  add->setToolTip(tr("Meshes (STL, OBJ, Collada, glTF), STEP or URDF files"));
  remove_->setObjectName(QStringLiteral("remove"));
  remove_->setEnabled(false);
  remove_->setToolTip(tr("Takes the selected rows out of the list (Del)"));
  auto* row = new QHBoxLayout;
  row->addWidget(add);
  row->addWidget(remove_);
  row->addStretch(1);
  row->addWidget(closeHoles_);
  closeHoles_->setObjectName(QStringLiteral("close-holes"));
  closeHoles_->setToolTip(tr("Closes holes of meshes whose edge lies in a plane; a warning says how many"));
  const auto* del = new QShortcut(QKeySequence::Delete, table_, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
  connect(del, &QShortcut::activated, this, &PartsDialog::removeSelected);
  connect(add, &QPushButton::clicked, this, &PartsDialog::chooseFiles);
  connect(remove_, &QPushButton::clicked, this, &PartsDialog::removeSelected);
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(table_->selectionModel()->hasSelection()); });
  return row;
}

QLayout* PartsDialog::makeEnd() {
  hint_->setObjectName(QStringLiteral("hint"));
  hint_->setWordWrap(true);
  hint_->setTextFormat(Qt::PlainText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  accept_ = buttons->button(QDialogButtonBox::Ok);
  accept_->setText(purpose_ == Purpose::NewScenario ? tr("&Create") : tr("&Add"));
  buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* row = new QHBoxLayout;
  row->addWidget(hint_, 1);
  row->addWidget(buttons);
  return row;
}

void PartsDialog::addFiles(const QStringList& files) {
  for (const QString& file : files) {
    const std::string path = QFileInfo(file).absoluteFilePath().toStdString();
    if (rowOf(path) < 0) addRow(table_->rowCount(), usualPart(path));
  }
  refresh();
  if (!measuring_.isBusy()) measureNext();
}

void PartsDialog::addRow(int row, const PartFile& part) {
  rows_.insert(rows_.begin() + row, {part, std::nullopt, false});
  table_->insertRow(row);
  for (const Column column : {kPart, kSize}) table_->setItem(row, column, new QTableWidgetItem);
  const QString file = QString::fromStdString(part.path);
  QString name = QFileInfo(file).fileName();
  if (!part.part.empty()) name += QStringLiteral(": ") + QString::fromStdString(part.part);
  table_->item(row, kPart)->setText(name);
  table_->item(row, kPart)->setToolTip(QDir::toNativeSeparators(file));
  QComboBox* role = makeRole(tr("Role of %1").arg(name));
  QComboBox* unit = makeUnit(tr("Unit of %1").arg(name));
  QComboBox* up = makeUp(tr("Axis of %1 that points up").arg(name));
  for (const auto& [column, combo] : {std::pair(kRole, role), std::pair(kUnit, unit), std::pair(kUp, up)}) {
    table_->setCellWidget(row, column, makeCell(combo));
  }
  if (!saysItsUnit(part.path)) return;
  for (QComboBox* fixed : {unit, up}) {
    fixed->setEnabled(false);
    fixed->setToolTip(tr("The file says its unit itself; Z is up"));
  }
}

QComboBox* PartsDialog::makeRole(const QString& name) {
  QComboBox* role = makeCombo("role", name, tr("What the part is in the scenario; all selected rows together"));
  const auto add = [role](const QString& label, PartRole value, const QString& tip) {
    role->addItem(label, static_cast<int>(value));
    role->setItemData(role->count() - 1, tip, Qt::ToolTipRole);
  };
  if (purpose_ == Purpose::NewScenario) {
    add(tr("Moves"), PartRole::Moves, tr("The part whose motion is looked for; several move as one"));
  }
  add(tr("Static"), PartRole::Static, tr("Stays where it is"));
  add(tr("Mobile"), PartRole::Mobile, tr("In the way, but a person could move it"));
  connect(role, QOverload<int>::of(&QComboBox::activated), this,
          [this, role] { chooseRole(rowOf(role, kRole), static_cast<PartRole>(role->currentData().toInt())); });
  return role;
}

QComboBox* PartsDialog::makeUnit(const QString& name) {
  QComboBox* unit = makeCombo("unit", name, tr("Unit of the file; of all selected rows together"));
  unit->addItem(tr("m"), 1.0);
  unit->addItem(tr("cm"), 0.01);
  unit->addItem(tr("mm"), 0.001);
  unit->addItem(tr("inch"), 0.0254);
  connect(unit, QOverload<int>::of(&QComboBox::activated), this, [this, unit] {
    for (const int i : rowsWith(rowOf(unit, kUnit))) {
      if (saysItsUnit(rows_[i].part.path)) continue;
      rows_[i].part.unit = unit->currentData().toDouble();
      rows_[i].unitChosen = true;
    }
    refresh();
  });
  return unit;
}

QComboBox* PartsDialog::makeUp(const QString& name) {
  QComboBox* up = makeCombo("up", name, tr("The file's axis that points up; of all selected rows together"));
  up->addItem(QStringLiteral("Z"), static_cast<int>(UpAxis::Z));
  up->addItem(QStringLiteral("Y"), static_cast<int>(UpAxis::Y));
  connect(up, QOverload<int>::of(&QComboBox::activated), this, [this, up] {
    for (const int i : rowsWith(rowOf(up, kUp))) {
      if (!saysItsUnit(rows_[i].part.path)) rows_[i].part.up = static_cast<UpAxis>(up->currentData().toInt());
    }
    refresh();
  });
  return up;
}

QString partFilePatterns() {
  return QStringLiteral("*.step *.stp *.STEP *.STP *.stl *.obj *.ply *.dae *.gltf *.glb *.urdf");
}

void PartsDialog::chooseFiles() {
  const QString folder =
      rows_.empty() ? folder_ : QFileInfo(QString::fromStdString(rows_.back().part.path)).absolutePath();
  addFiles(QFileDialog::getOpenFileNames(this, tr("Add the files of parts"), folder,
                                         tr("Parts (%1);;All files (*)").arg(partFilePatterns())));
}

void PartsDialog::removeSelected() {
  for (int row = table_->rowCount() - 1; row >= 0; --row) {
    if (!table_->selectionModel()->isRowSelected(row, QModelIndex())) continue;
    removeRow(row);
  }
  refresh();
}

void PartsDialog::removeRow(int row) {
  table_->removeRow(row);
  rows_.erase(rows_.begin() + row);
}

/// A role is given to all selected rows together; what else has moved before does not move any more.
void PartsDialog::chooseRole(int row, PartRole role) {
  if (role == PartRole::Moves) {
    for (Row& other : rows_) {
      if (other.part.role == role) other.part.role = PartRole::Static;
    }
  }
  for (const int i : rowsWith(row)) rows_[i].part.role = role;
  roleChosen_ = true;
  refresh();
}

/// The row alone, or with the others selected where it is one of them.
std::vector<int> PartsDialog::rowsWith(int row) const {
  const QItemSelectionModel& selection = *table_->selectionModel();
  if (!selection.isRowSelected(row, QModelIndex())) return {row};
  std::vector<int> rows;
  for (int i = 0; i < table_->rowCount(); ++i) {
    if (selection.isRowSelected(i, QModelIndex())) rows.push_back(i);
  }
  return rows;
}

int PartsDialog::rowOf(const QObject* combo, Column column) const {
  int row = 0;
  while (table_->cellWidget(row, column) != combo->parent()) ++row;
  return row;
}

/// -1 where the file is not listed.
int PartsDialog::rowOf(const std::string& path) const {
  const auto same = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.part.path == path; });
  return same == rows_.end() ? -1 : static_cast<int>(same - rows_.begin());
}

void PartsDialog::measureNext() {
  const auto next = std::find_if(rows_.begin(), rows_.end(), [](const Row& row) { return !row.inFile; });
  if (next == rows_.end()) return;
  const auto measure = [this, path = next->part.path](const WorkWatch& watch) -> BackgroundTask::Delivery {
    GeometryCache read;
    const auto measured =
        std::make_shared<const Result<std::vector<MeasuredPart>>>(partsInFile(path, read, watch.stop));
    return [this, path, measured, read] {
      read_.insert(read.begin(), read.end());
      setMeasured(path, *measured);
    };
  };
  measuredPath_ = next->part.path;
  measuring_.start("reading the parts", measure, atOnce_);
}

/// The row of the file becomes one a part.
void PartsDialog::setMeasured(const std::string& path, const Result<std::vector<MeasuredPart>>& measured) {
  const int row = rowOf(path);
  if (row >= 0 && !measured) {
    rows_[row].inFile = measured.error();
  } else if (row >= 0 && measured->size() == 1) {
    rows_[row].inFile = measured->front().inFile;
  } else if (row >= 0) {
    PartFile part = rows_[row].part;
    removeRow(row);
    for (std::size_t i = 0; i < measured->size(); ++i) {
      part.part = (*measured)[i].part;
      addRow(row + static_cast<int>(i), part);
      rows_[row + static_cast<int>(i)].inFile = (*measured)[i].inFile;
    }
  }
  refresh();
  measureNext();
}

bool PartsDialog::isMeasured() const {
  return std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.inFile.has_value(); });
}

bool PartsDialog::hasMoving() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.part.role == PartRole::Moves; });
}

/// Of the files that do not say theirs, as long as nobody has chosen.
void PartsDialog::guessUnits() {
  unitGuess_.reset();
  if (!isMeasured()) return;
  std::vector<Row*> guessed;
  std::vector<Box3> boxes;
  for (Row& row : rows_) {
    if (row.unitChosen || !row.inFile->ok() || !saysNoUnit(row.part.path)) continue;
    guessed.push_back(&row);
    boxes.push_back(**row.inFile);
  }
  if (guessed.empty()) return;
  unitGuess_ = guessUnit(boxes);
  for (Row* row : guessed) row->part.unit = unitGuess_->unit;
}

/// The first of the smallest parts, as long as nobody has chosen.
void PartsDialog::guessWhatMoves() {
  if (purpose_ != Purpose::NewScenario || roleChosen_ || !isMeasured()) return;
  Row* smallest = nullptr;
  const auto diagonal = [](const Row& row) { return boxOfPart(row.part, **row.inFile).diagonal().norm(); };
  for (Row& row : rows_) {
    row.part.role = PartRole::Static;
    if (!row.inFile->ok()) continue;
    if (smallest == nullptr || diagonal(row) < kSmaller * diagonal(*smallest)) smallest = &row;
  }
  if (smallest != nullptr) smallest->part.role = PartRole::Moves;
}

void PartsDialog::refresh() {
  guessUnits();
  guessWhatMoves();
  for (int row = 0; row < table_->rowCount(); ++row) showRow(row);
  hint_->setText(hint());
  accept_->setEnabled(isComplete());
}

void PartsDialog::showRow(int row) {
  const PartFile& part = rows_[row].part;
  const auto show = [this, row](Column column, const QVariant& value) {
    auto* combo = table_->cellWidget(row, column)->findChild<QComboBox*>();
    combo->setCurrentIndex(combo->findData(value));
  };
  show(kRole, static_cast<int>(part.role));
  show(kUnit, part.unit);
  show(kUp, static_cast<int>(part.up));
  QFont font = table_->font();
  font.setBold(part.role == PartRole::Moves);
  table_->item(row, kPart)->setFont(font);
  showSize(row);
}

void PartsDialog::showSize(int row) {
  const auto& inFile = rows_[row].inFile;
  QTableWidgetItem& item = *table_->item(row, kSize);
  if (!inFile) {
    item.setText(QStringLiteral("…"));
  } else if (inFile->ok()) {
    item.setText(sizeText(boxOfPart(rows_[row].part, **inFile)));
  } else {
    item.setText(tr("cannot be read"));
    item.setToolTip(reasonText(inFile->error()));
    item.setForeground(palette().brush(QPalette::BrightText));
  }
}

/// What is missing, in one sentence.
QString PartsDialog::hint() const {
  if (rows_.empty()) return tr("Add the files of the parts.");
  for (const Row& row : rows_) {
    if (row.inFile && !row.inFile->ok()) return reasonText(row.inFile->error());
  }
  if (!isMeasured()) return tr("The files are being read.");
  if (purpose_ == Purpose::NewScenario && !hasMoving()) return tr("Choose the part that moves.");
  if (unitGuess_ && unitGuess_->inDoubt) {
    return tr("Is the unit right? The files do not state it, and their size does not decide it. Choose the unit.");
  }
  if (unitGuess_ && unitGuess_->unit == 1.0)
    return tr("The files do not say their unit: by their size it is the metre.");
  return rows_.size() > 1 ? tr("Select several rows to choose their role, unit or axis together.") : QString();
}

std::vector<PartFile> PartsDialog::parts() const {
  std::vector<PartFile> parts;
  for (const Row& row : rows_) {
    parts.push_back(row.part);
    parts.back().closeHoles = closeHoles_->isChecked() && isMeshFile(row.part.path);
  }
  return parts;
}

bool PartsDialog::isComplete() const {
  const bool readable =
      std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.inFile && row.inFile->ok(); });
  return !rows_.empty() && readable && (purpose_ == Purpose::AddParts || hasMoving());
}

}  // namespace glissade
