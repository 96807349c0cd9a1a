#include "engine/study/finding_check.h"

#include <algorithm>
#include <limits>

#include "engine/study/cell_value.h"

namespace glissade {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::size_t> select(const CellSelection& selection, const Study& study) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyCell& cell = study.cells[i];
    if (contains(selection.rows, cell.row) && contains(selection.strategies, cell.strategy) &&
        contains(selection.operators, cell.operatorName) && contains(selection.scenarios, cell.scenario)) {
      cells.push_back(i);
    }
  }
  return cells;
}

bool agree(const StudyCell& a, const StudyCell& b, const std::vector<PairBy>& keys) {
  return std::all_of(keys.begin(), keys.end(), [&](PairBy key) {
    if (key == PairBy::Operator) return a.operatorName == b.operatorName;
    return key == PairBy::Scenario ? a.scenario == b.scenario : a.strategy == b.strategy;
  });
}

/// Compares all pairs and keeps the one with the strongest evidence against the finding.
class Check {
 public:
  Check(const Finding& finding, const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words)
      : finding_(finding), study_(study), summaries_(summaries), words_(words) {}

  CheckedFinding run() {
    const auto cells = select(finding_.cells, study_);
    if (const auto* bound = std::get_if<double>(&finding_.than)) {
      for (const std::size_t cell : cells) compareWithNumber(cell, *bound);
    } else {
      const auto others = select(std::get<CellSelection>(finding_.than), study_);
      for (const std::size_t cell : cells) {
        for (const std::size_t other : others) {
          if (cell != other && agree(study_.cells[cell], study_.cells[other], finding_.pairBy)) compare(cell, other);
        }
      }
    }
    return conclude();
  }

 private:
  std::optional<double> value(std::size_t cell) {
    const auto found = valueOf(summaries_[cell], finding_.quantity);
    if (found) return found->value;
    missing_ =
        words_(summaries_[cell].runs == 0 ? GLISSADE_TEXT("%1 has not been run") : GLISSADE_TEXT("%1 was never solved"),
               {study_.cells[cell].label});
    return std::nullopt;
  }

  std::string show(double value) const {
    return finding_.quantity.measure == "success_rate" ? percent(value) : shortNumber(value);
  }

  bool below() const { return finding_.relation == Relation::Below; }

  void compareWithNumber(std::size_t cell, double bound) {
    const auto left = value(cell);
    if (!left) return;
    const double against = finding_.relation == Relation::Below ? *left - bound : bound - *left;
    note(against < 0.0, against,
         words_(below() ? GLISSADE_TEXT("%1: %2; wanted below %3") : GLISSADE_TEXT("%1: %2; wanted above %3"),
                {study_.cells[cell].label, show(*left), show(bound)}));
  }

  void compare(std::size_t cell, std::size_t other) {
    const auto left = value(cell);
    const auto right = value(other);
    if (!left || !right) return;
    const double bound = finding_.factor * *right;
    const bool agrees = finding_.relation == Relation::Below ? *left < bound : *left > bound;
    // Distance of the pair from its bound: a ratio, or a difference where the bound is zero.
    const double ratio = bound > 0.0 ? *left / bound : *left - bound + 1.0;
    std::string text = words_(GLISSADE_TEXT("%1: %2 against %3: %4"),
                              {study_.cells[cell].label, show(*left), study_.cells[other].label, show(*right)});
    if (*right > 0.0) {
      text = words_(
          below() ? GLISSADE_TEXT("%1, %2 times; wanted below %3") : GLISSADE_TEXT("%1, %2 times; wanted above %3"),
          {text, shortNumber(*left / *right), shortNumber(finding_.factor)});
    }
    note(agrees, finding_.relation == Relation::Below ? ratio : -ratio, text);
  }

  void note(bool agrees, double against, const std::string& text) {
    ++result_.compared;
    result_.agreeing += agrees ? 1 : 0;
    if (against <= worst_) return;
    worst_ = against;
    result_.numbers = text;
  }

  CheckedFinding conclude() {
    if (result_.agreeing < result_.compared) {
      result_.verdict = Verdict::Refuted;
    } else if (result_.compared > 0 && missing_.empty()) {
      result_.verdict = Verdict::Holds;
    } else if (!missing_.empty()) {
      result_.numbers += (result_.numbers.empty() ? "" : "; ") + missing_;
    } else {
      result_.numbers = words_(GLISSADE_TEXT("Its rows are not part of this size of the study"));
    }
    return result_;
  }

  const Finding& finding_;
  const Study& study_;
  const std::vector<CellSummary>& summaries_;
  const StudyWords& words_;
  CheckedFinding result_;
  double worst_ = -std::numeric_limits<double>::infinity();
  std::string missing_;  ///< reason why the last incomparable pair cannot be compared
};

}  // namespace

const char* name(Verdict verdict) {
  if (verdict == Verdict::Holds) return "holds";
  return verdict == Verdict::Refuted ? "does not hold" : "open";
}

CheckedFinding checkFinding(const Finding& finding, const Study& study, const std::vector<CellSummary>& summaries,
                            const StudyWords& words) {
  return Check(finding, study, summaries, words).run();
}

}  // namespace glissade
