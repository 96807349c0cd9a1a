#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QToolButton>

#include "widgets/controls/action_catalogue.h"
#include "widgets/places/attribute_view.h"
#include "widgets/places/semantics_tree.h"

namespace glissade {

/// The editor of semantic attributes: a tree of places and bodies, the attributes of the selection below it, and
/// attributes of the user's own.
class SemanticsPanel final : public QWidget {
  Q_OBJECT

 public:
  SemanticsPanel(SemanticDocument& document, const ActionCatalogue& actions, QWidget* parent = nullptr);

  void setBusy(bool busy);
  /// Selects the method that finds places (an id of the registry).
  void setIdentifier(const std::string& id);
  /// The following carry out attribute.add, attribute.rename and attribute.remove.
  void addAttribute();
  void renameAttribute();
  void removeAttribute();

 signals:
  void identifierChosen(const std::string& id);

 private:
  void enableActions();
  void showWarnings();
  void showRefusal(const Diagnostic& why);

  SemanticDocument& document_;
  const ActionCatalogue& actions_;
  QLineEdit* filter_;
  QComboBox* identifier_;
  QProgressBar* busy_;
  SemanticsTree* tree_;
  AttributeView* attributes_;
  QLabel* warning_;
  QToolButton* removeStrays_;  ///< removes edits that have no effect; visible if there are any
  QLabel* refusal_;
};

}  // namespace glissade
