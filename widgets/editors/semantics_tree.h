#pragma once

#include <QHash>
#include <QTreeWidget>

#include "widgets/document/semantic_document.h"

namespace glissade {

/// Places, assemblies and bodies; what is selected here is selected in the scene, and the other way round. Places
/// can be renamed in place (F2).
class SemanticsTree final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit SemanticsTree(SemanticDocument& document, QWidget* parent = nullptr);

  /// Hides, and deselects, what does not hold the text in its name or its values.
  void setFilter(const QString& text);

 signals:
  void refused(const glissade::Diagnostic& why);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void hideUnwanted();
  void showPlaces();
  void showAssemblies();
  void showBodies();
  void describe(QTreeWidgetItem& item, const QString& id);
  void takeSelection();
  void showSelection();
  void rename(QTreeWidgetItem* item);

  SemanticDocument& document_;
  QTreeWidgetItem* places_;
  QTreeWidgetItem* assemblies_;  ///< hidden where there are none
  QTreeWidgetItem* bodies_;
  QString filter_;
  bool updating_ = false;
};

}  // namespace glissade
