#pragma once

#include <QTreeWidget>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

#include "engine/places/attribute.h"
#include "widgets/document/semantic_document.h"

namespace glissade {

/// The editor of one attribute's value, made for its type: check box, spin box with unit, combo box or line of text.
/// Different values of several owners are shown as "—" until one is set. The wheel changes only an editor that has the
/// focus, and undoing is left to the window.
class AttributeEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit AttributeEditor(const AttributeDefinition& definition, QWidget* parent = nullptr);

  /// Shows the value, without a signal. Nothing: the owners have different values.
  void setValue(const std::optional<AttributeValue>& value);

 signals:
  void edited(const glissade::AttributeValue& value);
  void finished();  ///< the next change is a separate edit

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeCheckBox();
  QWidget* makeSpinBox(const AttributeDefinition& definition);
  QWidget* makeNumberBox(const AttributeDefinition& definition);
  template <typename Box>
  QWidget* connected(Box* box, const AttributeDefinition& definition, const std::string& unit, double scale = 1.0);
  QWidget* makeComboBox(const AttributeDefinition& definition);
  QWidget* makeLine();

  std::function<void(const std::optional<AttributeValue>&)> show_;
};

/// The attributes of the selection: value with an editor for its type, source, and a button that removes an edit. F2,
/// Enter and Space on a row lead to its editor.
class AttributeView final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit AttributeView(SemanticDocument& document, QWidget* parent = nullptr);

  /// The attribute of the current row; empty: none.
  std::string currentAttribute() const;
  /// The owner of the attributes that are shown.
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
