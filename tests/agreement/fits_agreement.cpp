// Compares the fits that three commands find for each pair of a product: the table of `fits`, a scenario of one moving
// body made by `new` and loaded by `plan`, and the fits that `sequence` uses for its motions. Kind, status, the body
// that is taken thinner and the amount have to be equal, to a thousandth of the allowance.
//
// usage: fits_agreement FILE [MOST]
//
// FILE is a STEP file. `plan` is run for each body with a pair; with MOST for that many bodies, spread evenly. Exit
// code 0: all pairs agree; 1: some differ; 2: a file cannot be read.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "engine/files/part_files.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario_io.h"
#include "engine/fits/fit_table.h"
#include "engine/sequence/product_fits.h"

namespace {

using namespace glissade;

/// The statement about a pair while one of its bodies moves.
struct Said {
  std::string kind;
  double ofMoving = 0.0;  ///< thickness removed from the moving body, metres
  double ofOther = 0.0;
  bool clash = false;

  std::string text() const {
    return kind + (clash ? ", clash" : "") + ", moving " + std::to_string(1e6 * ofMoving) + " um, other " +
           std::to_string(1e6 * ofOther) + " um";
  }
};

/// Tolerance as a share of the allowance. `plan` has the object in the frame of the file. Where a point of an overlap
/// is equally near to two faces, rounding decides which face its depth counts for.
constexpr double kTies = 1e-3;
constexpr double kRounding = 1e-9;

bool areSame(double a, double b) { return std::abs(a - b) <= kRounding + kTies * std::max(a, b); }

bool areSame(const Said& a, const Said& b) {
  return a.kind == b.kind && a.clash == b.clash && areSame(a.ofMoving, b.ofMoving) && areSame(a.ofOther, b.ofOther);
}

/// Statements by the other body.
using SaidOfOthers = std::map<std::string, Said>;

void add(const Fit& fit, Said& said) {
  if (fit.thinned) (fit.yields ? said.ofOther : said.ofMoving) = fit.allowance;
}

class Agreement {
 public:
  explicit Agreement(std::string file) : file_(std::move(file)) {}

  bool compare(std::size_t most) {
    table();
    sequence();
    std::vector<std::string> moving;
    for (const auto& [name, others] : table_) moving.push_back(name);
    const std::size_t step = most == 0 ? 1 : std::max<std::size_t>(1, moving.size() / most);
    std::size_t asked = 0;
    for (std::size_t i = 0; i < moving.size(); i += step, ++asked) plan(moving[i]);
    std::cout << file_ << ": " << bodies_ << " bodies, " << pairs_ << " pairs; compared with sequence " << sequenced_
              << ", with plan " << planned_ << " (" << asked << " moving bodies); " << differences_ << " differ\n";
    return differences_ == 0;
  }

 private:
  template <class Value>
  static Value valid(Result<Value> result) {
    if (!result) throw toString(result.error());
    return std::move(*result);
  }

  /// Fills the table as runFits() prints it.
  void table() {
    ProductFile loaded = valid(readProduct(file_));
    AssembledProduct product = loaded.product;
    product.bodies = aboutTheirMiddles(std::move(product.bodies));
    ThreadTeam alone(0);
    const FitTable table = valid(FitTable::find(product, alone, {}));
    bodies_ = product.bodies.size();
    pairs_ = table.pairs().size();
    for (const PairFit& pair : table.pairs()) {
      for (const bool moveA : {true, false}) {
        Said said{kContactKindNames.of(pair.contact.kind)};
        const PairWay& way = pair.ways[moveA ? 0 : 1];
        for (const Fit& fit : way.taken) add(fit, said);
        said.clash = !way.refused.empty();
        table_[nameOf(product, moveA ? pair.a : pair.b)][nameOf(product, moveA ? pair.b : pair.a)] = said;
      }
    }
  }

  static std::string nameOf(const AssembledProduct& product, const BodyId& id) {
    return product.bodies[product.indexOf(id)].name;
  }

  void report(const std::string& who, const std::string& moving, const std::string& other, const std::string& said) {
    ++differences_;
    const auto& others = table_[moving];
    const auto known = others.find(other);
    std::cout << file_ << ": '" << moving << "' past '" << other << "': " << who << " says " << said << "; fits says "
              << (known == others.end() ? "nothing" : known->second.text()) << "\n";
  }

  /// Compares every pair of the moving body in both lists.
  void compare(const std::string& who, const std::string& moving, const SaidOfOthers& found, std::size_t& count) {
    const SaidOfOthers& expected = table_[moving];
    for (const auto& [other, said] : found) {
      ++count;
      const auto known = expected.find(other);
      if (known == expected.end() || !areSame(known->second, said)) report(who, moving, other, said.text());
    }
    for (const auto& [other, said] : expected) {
      if (found.count(other) == 0) report(who, moving, other, "nothing");
    }
  }

  void sequence() {
    const ProductFile loaded = valid(loadProduct(file_));
    const AssembledProduct& product = loaded.product;
    ThreadTeam alone(0);
    const ProductFits fits = valid(ProductFits::find(product, alone, {}));
    std::vector<SaidOfOthers> found(product.bodies.size());
    for (const Contact& contact : fits.contacts()) {
      for (const bool moveA : {true, false}) {
        const std::size_t moving = moveA ? contact.a : contact.b;
        const std::size_t other = moveA ? contact.b : contact.a;
        Said said{kContactKindNames.of(contact.kind)};
        for (const Fit& fit : fits.fitsOf(moving)) {
          if (fit.obstacle == other) add(fit, said);
        }
        // A whole pair in contact blocks the motion: the sequence has no list of clashes.
        said.clash = isWholeClash(product.bodies[moving].name, product.bodies[other].name, said);
        found[moving][product.bodies[other].name] = said;
      }
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i].empty()) compare("sequence", product.bodies[i].name, found[i], sequenced_);
    }
  }

  bool isWholeClash(const std::string& moving, const std::string& other, const Said& said) {
    const auto known = table_[moving].find(other);
    return known != table_[moving].end() && known->second.clash && said.ofMoving == 0.0 && said.ofOther == 0.0;
  }

  /// Finds the fits as `new` makes the scenario and `plan` loads it.
  void plan(const std::string& name) {
    PartFile moves = usualPart(file_ + ":" + name);
    moves.role = PartRole::Moves;
    PartFile others = usualPart(file_);
    const Scenario scenario = valid(scenarioOfParts({moves, others}, &read_));
    const LoadedScenario loaded = valid(loadGeometry(scenario, ".", "", read_));
    SaidOfOthers found;
    for (const Contact& contact : loaded.fits.contacts) {
      found[loaded.obstacles[contact.a].name].kind = kContactKindNames.of(contact.kind);
    }
    for (const Fit& fit : loaded.fits.allowed) add(fit, found[loaded.obstacles[fit.obstacle].name]);
    for (const Fit& fit : loaded.fits.clashes) found[loaded.obstacles[fit.obstacle].name].clash = true;
    compare("plan", name, found, planned_);
  }

  std::string file_;
  GeometryCache read_;
  std::map<std::string, SaidOfOthers> table_;  ///< statements by the moving body
  std::size_t bodies_ = 0;
  std::size_t pairs_ = 0;
  std::size_t sequenced_ = 0;
  std::size_t planned_ = 0;
  std::size_t differences_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: fits_agreement FILE [MOST]\n";
    return 2;
  }
  try {
    return Agreement(argv[1]).compare(argc == 3 ? std::stoul(argv[2]) : 0) ? 0 : 1;
  } catch (const std::string& why) {
    std::cerr << argv[1] << ": " << why << "\n";
  } catch (const std::exception& error) {
    std::cerr << argv[1] << ": " << error.what() << "\n";
  }
  return 2;
}
