#pragma once

#include <QHash>
#include <QTreeWidget>

#include "widgets/document/semantic_document.h"

namespace glissade {

/// A tree of places, assemblies and bodies, which shares its selection with the scene. Places can be renamed in place
/// (F2).
class SemanticsTree final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit SemanticsTree(SemanticDocument& document, QWidget* parent = nullptr);

  /// Hides and deselects the rows whose name and values do not contain the text.
  void setFilter(const QString& text);

 signals:
  void refused(const glissade::Diagnostic& why);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void hideFilteredRows();
  void showPlaces();
  void showAssemblies();
  void showBodies();
  void describe(QTreeWidgetItem& item, const QString& id);
  void takeSelection();
  void showSelection();
  void rename(QTreeWidgetItem* item);

  SemanticDocument& document_;
  QTreeWidgetItem* places_;
  QTreeWidgetItem* assemblies_;  ///< hidden if there are none
  QTreeWidgetItem* bodies_;
  QString filter_;
  bool updating_ = false;
};

}  // namespace glissade
