#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>

#include "engine/planning/coarse/strategy_rules.h"

namespace glissade {

/// Shows the rules of a strategy, the functions f and g of paper 2, equation (1), and the choice of planners, and lets
/// a person change them into own rules. Errors are shown while the person types.
class RulesDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `own`: the scenario's rules, or initial ones. `table`: the attributes that rules may name.
  RulesDialog(const StrategyRules& own, AttributeTable table, QWidget* parent = nullptr);

  StrategyRules rules() const;
  bool isSound() const;

 private:
  QPlainTextEdit* makeFunction(const char* id, const QString& tip);
  QLayout* makeBeginning();
  QLayout* makeFineButtons();
  void setUpFine();
  QString names() const;
  void show(const StrategyRules& rules);
  void addFine(int row, const FineRule& rule);
  void moveFine(int by);
  FineRule fineAt(int row) const;
  void check();

  AttributeTable table_;
  QComboBox* preset_;
  QPlainTextEdit* node_;
  QPlainTextEdit* edge_;
  QTableWidget* fine_;
  QCheckBox* loop_;
  QCheckBox* fitted_;
  QLabel* trouble_;
  QPushButton* accept_ = nullptr;
};

}  // namespace glissade
