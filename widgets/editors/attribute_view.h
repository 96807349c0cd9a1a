#pragma once

#include <QTreeWidget>
#include <vector>

#include "widgets/document/semantic_document.h"
#include "widgets/editors/attribute_editor.h"

namespace glissade {

/// The attributes of what is selected: value with an editor for its type, where it comes from, and a
/// button that takes an edit back. F2, Enter and Space on a row lead to its editor.
class AttributeView final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit AttributeView(SemanticDocument& document, QWidget* parent = nullptr);

  /// The attribute of the current row; empty: none.
  std::string currentAttribute() const;
  /// Whose attributes are shown.
  AttributeOwner owner() const { return document_.selection().owner(); }

 signals:
  void refused(const glissade::Diagnostic& why);

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Row {
    std::string attribute;
    AttributeEditor* editor;
    QTreeWidgetItem* item;
  };

  void refresh();
  void rebuild(const std::vector<AttributeDefinition>& definitions);
  void addRow(const AttributeDefinition& definition);
  void showValues(Row& row);
  void showReset(const Row& row, bool visible);
  void set(const std::string& attribute, const std::optional<AttributeValue>& value);
  std::vector<ProvenValue> valuesOf(const std::string& attribute) const;

  SemanticDocument& document_;
  std::vector<AttributeDefinition> shown_;
  std::vector<Row> rows_;
};

}  // namespace glissade
