#pragma once

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

#include <vector>

#include "engine/scenario/kept_path_proof.h"
#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// A row of the panel.
struct KeptPathRow {
  KeptPathPtr path;
  KeptPathProof proof;
  bool shown = false;    ///< drawn beside the others
  bool current = false;  ///< it is the path that is played and exported
};

/// The colour of the path at this index, where several are shown.
QColor keptPathColour(std::size_t index);
/// "Automatic", as the strategy is called in the window.
QString strategyName(const std::string& plannerId);
/// What became of a kept path, in a few words.
QString proofText(const KeptPathProof& proof);

/// The paths that are kept: what they are, whether they hold in the scenario as it is, and which are shown.
class KeptPathsPanel final : public QWidget {
  Q_OBJECT

 public:
  KeptPathsPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// `unkept`: the path that was found last is not among them.
  void setRows(const std::vector<KeptPathRow>& rows, bool unkept);
  /// Names of the selected rows, from the top.
  std::vector<std::string> selected() const;
  /// False: there is no such row.
  bool select(const std::string& name);
  /// Lets the user type another name into the selected row.
  void editName();

 signals:
  /// Lengths have another unit: what is shown has to be written again.
  void lengthUnitChanged();
  void selectionChanged();
  void shownChanged(const std::string& name, bool shown);
  void renamed(const std::string& name, const std::string& newName);
  /// A double click, or Enter.
  void activated(const std::string& name);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void takeChange(QTreeWidgetItem* item, int column);

  QLabel* summary_;
  QTreeWidget* table_;
};

}  // namespace glissade
