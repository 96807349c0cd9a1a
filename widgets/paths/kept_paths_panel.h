#pragma once

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

#include <vector>

#include "engine/files/kept_path_proof.h"
#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// A row of the panel.
struct KeptPathRow {
  KeptPathPtr path;
  KeptPathProof proof;
  bool shown = false;    ///< drawn besides the others
  bool current = false;  ///< it is the path that is played and exported
};

/// The colour of the path at this index, if several are shown.
QColor keptPathColour(std::size_t index);
/// Name of the strategy in the window, such as "Automatic".
QString strategyName(const std::string& plannerId);
/// The state of a kept path's proof, in a few words.
QString proofText(const KeptPathProof& proof);

/// The kept paths: their figures, whether they are valid in the present scenario, and which of them are shown.
class KeptPathsPanel final : public QWidget {
  Q_OBJECT

 public:
  KeptPathsPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// `unkept`: the path that was found last is not kept.
  void setRows(const std::vector<KeptPathRow>& rows, bool unkept);
  /// Names of the selected rows, from the top.
  std::vector<std::string> selected() const;
  /// False if there is no such row.
  bool select(const std::string& name);
  /// Starts editing the name of the selected row.
  void editName();

 signals:
  /// The unit of lengths has changed, so that the texts have to be written again.
  void lengthUnitChanged();
  void selectionChanged();
  void shownChanged(const std::string& name, bool shown);
  void renamed(const std::string& name, const std::string& newName);
  /// A row was double-clicked, or Enter was pressed on it.
  void activated(const std::string& name);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void takeChange(QTreeWidgetItem* item, int column);

  QLabel* summary_;
  QTreeWidget* table_;
};

}  // namespace glissade
