#pragma once

#include <string>
#include <variant>
#include <vector>

namespace glissade {

/// A number of a cell: "success_rate", or a column of runs.csv or timing.csv with a statistic over a
/// kind of runs.
struct Quantity {
  std::string measure;
  std::string statistic;  ///< "median" or "mean"; of success_rate neither
  std::string over;       ///< "solved" or "all" runs
};

/// Cells with one of the named rows, strategies, operators and scenarios; an empty list is any.
struct CellSelection {
  std::vector<std::string> rows;
  std::vector<std::string> strategies;
  std::vector<std::string> operators;
  std::vector<std::string> scenarios;
};

/// What cells have in common that are compared with each other.
enum class PairBy { Operator, Scenario, Strategy };

enum class Relation { Below, Above };

/// A sentence that a study is to prove or refute: of every pair of a cell of `cells` and one of `than`
/// that agree in `pairBy`, the first one's quantity is below (above) `factor` times the second's; or,
/// where `than` is a number, below (above) it.
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
