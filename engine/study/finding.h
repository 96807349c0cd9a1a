#pragma once

#include <string>
#include <variant>
#include <vector>

namespace glissade {

/// A quantity of a cell: "success_rate", or a column of runs.csv or timing.csv with a statistic over a kind of runs.
struct Quantity {
  std::string measure;
  std::string statistic;  ///< "median" or "mean"; empty for success_rate
  std::string over;       ///< "solved" or "all" runs
};

/// Selects cells by rows, strategies, operators and scenarios; an empty list selects all.
struct CellSelection {
  std::vector<std::string> rows;
  std::vector<std::string> strategies;
  std::vector<std::string> operators;
  std::vector<std::string> scenarios;
};

/// Property that two compared cells have in common.
enum class PairBy { Operator, Scenario, Strategy };

enum class Relation { Below, Above };

/// A claim that a study proves or refutes. For every pair of a cell of `cells` and one of `than` that agree in
/// `pairBy`, the quantity of the first is below (above) `factor` times that of the second; or, where `than` is a
/// number, below (above) it.
struct Finding {
  std::string text;
  Quantity quantity;
  CellSelection cells;
  Relation relation = Relation::Below;
  std::variant<CellSelection, double> than;
  double factor = 1.0;
  std::vector<PairBy> pairBy;
};

}  // namespace glissade
