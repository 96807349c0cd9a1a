#include "engine/sequence/static_equilibrium.h"

#include <coin/Clp_C_Interface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>

namespace glissade {
namespace {

constexpr int kEquations = 6;
constexpr double kUnbalanced = 0.01;
/// Weight of a body without weight, for the centre of several bodies.
constexpr double kLeastWeight = 1e-12;
constexpr int kMostIterations = 200'000;

struct ClpDeleter {
  void operator()(Clp_Simplex* model) const { Clp_deleteModel(model); }
};

/// The columns of a linear program with their entries.
class Columns {
 public:
  void begin(double cost) {
    starts.push_back(static_cast<CoinBigIndex>(rows.size()));
    costs.push_back(cost);
  }
  void add(int row, double value) {
    if (value == 0.0) return;
    rows.push_back(row);
    values.push_back(value);
  }
  void end() { starts.push_back(static_cast<CoinBigIndex>(rows.size())); }

  std::vector<CoinBigIndex> starts;
  std::vector<int> rows;
  std::vector<double> values;
  std::vector<double> costs;
};

/// Minimizes the sum of the unbalanced forces and torques. Forces are divided by the mean weight, torques by the mean
/// weight times the size of the body.
class Balance {
 public:
  Balance(const std::vector<SupportedBody>& bodies, const Vector3& gravity)
      : bodies_(bodies), firstRow_(bodies.size(), -1) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      if (bodies[body].fixed) continue;
      firstRow_[body] = kEquations * count++;
      sum += bodies[body].weight;
    }
    unit_ = sum > 0.0 ? sum / count : 1.0;
    rowCount_ = kEquations * count;
    wanted_.assign(static_cast<std::size_t>(rowCount_), 0.0);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      if (firstRow_[body] < 0) continue;
      const Vector3 force = -bodies[body].weight / unit_ * gravity;
      for (int axis = 0; axis < 3; ++axis) wanted_[static_cast<std::size_t>(firstRow_[body]) + axis] = force[axis];
    }
  }

  /// Adds the force on `b` and the opposite force on `a`.
  void addForce(const SupportPoint& at, const Vector3& force) {
    if (firstRow_[at.a] < 0 && firstRow_[at.b] < 0) return;
    columns_.begin(0.0);
    addWrench(at.b, at.point, force);
    addWrench(at.a, at.point, -force);
  }

  /// The unbalanced part of each body's forces, in shares of its weight.
  std::vector<double> solve() {
    std::vector<double> unbalanced(bodies_.size(), 0.0);
    if (rowCount_ == 0) return unbalanced;
    const std::size_t forces = columns_.costs.size();
    for (int row = 0; row < rowCount_; ++row) {
      for (const double sign : {1.0, -1.0}) {
        columns_.begin(1.0);
        columns_.add(row, sign);
      }
    }
    columns_.end();
    const auto columnCount = static_cast<int>(columns_.costs.size());
    const std::unique_ptr<Clp_Simplex, ClpDeleter> model(Clp_newModel());
    Clp_setLogLevel(model.get(), 0);
    const std::vector<double> lower(columns_.costs.size(), 0.0);
    Clp_loadProblem(model.get(), columnCount, rowCount_, columns_.starts.data(), columns_.rows.data(),
                    columns_.values.data(), lower.data(), nullptr, columns_.costs.data(), wanted_.data(),
                    wanted_.data());
    Clp_setMaximumIterations(model.get(), kMostIterations);
    Clp_dual(model.get(), 0);
    const double* solution = Clp_getColSolution(model.get());
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      if (firstRow_[body] < 0 || bodies_[body].weight <= 0.0) continue;
      for (int row = firstRow_[body]; row < firstRow_[body] + kEquations; ++row) {
        const std::size_t slack = forces + 2 * static_cast<std::size_t>(row);
        unbalanced[body] += (solution[slack] + solution[slack + 1]) * unit_ / bodies_[body].weight;
      }
    }
    return unbalanced;
  }

 private:
  void addWrench(std::size_t body, const Vector3& point, const Vector3& force) {
    const int row = firstRow_[body];
    if (row < 0) return;
    const Vector3 torque = (point - bodies_[body].centre).cross(force) / bodies_[body].size;
    for (int axis = 0; axis < 3; ++axis) {
      columns_.add(row + axis, force[axis]);
      columns_.add(row + 3 + axis, torque[axis]);
    }
  }

  const std::vector<SupportedBody>& bodies_;
  std::vector<int> firstRow_;  ///< -1 for a fixed body
  int rowCount_ = 0;
  double unit_ = 1.0;
  std::vector<double> wanted_;
  Columns columns_;
};

/// Merges bonded bodies into one body, which is fixed if one of its parts is.
class BondedBodies {
 public:
  BondedBodies(const std::vector<SupportedBody>& bodies, const std::vector<SupportPoint>& points)
      : whole_(bodies.size()) {
    std::iota(whole_.begin(), whole_.end(), std::size_t{0});
    for (const SupportPoint& at : points) {
      if (at.bonded) whole_[rootOf(at.a)] = rootOf(at.b);
    }
    for (std::size_t& body : whole_) body = rootOf(body);
    std::map<std::size_t, std::size_t> places;
    for (std::size_t& body : whole_) body = places.try_emplace(body, places.size()).first->second;
    joined_.assign(places.size(), {});
    joinMasses(bodies);
    joinSizes(bodies);
  }

  const std::vector<SupportedBody>& joined() const { return joined_; }
  /// For each body, the index of the merged body that contains it.
  const std::vector<std::size_t>& whole() const { return whole_; }

 private:
  std::size_t rootOf(std::size_t body) const {
    while (whole_[body] != body) body = whole_[body];
    return body;
  }

  void joinMasses(const std::vector<SupportedBody>& bodies) {
    std::vector<double> sums(joined_.size(), 0.0);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      SupportedBody& joined = joined_[whole_[body]];
      const double share = std::max(bodies[body].weight, kLeastWeight);
      joined.weight += bodies[body].weight;
      joined.centre += share * bodies[body].centre;
      joined.fixed = joined.fixed || bodies[body].fixed;
      sums[whole_[body]] += share;
    }
    for (std::size_t i = 0; i < joined_.size(); ++i) joined_[i].centre /= sums[i];
  }

  void joinSizes(const std::vector<SupportedBody>& bodies) {
    for (SupportedBody& joined : joined_) joined.size = 0.0;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      SupportedBody& joined = joined_[whole_[body]];
      joined.size = std::max(joined.size, (bodies[body].centre - joined.centre).norm() + bodies[body].size);
    }
  }

  std::vector<std::size_t> whole_;
  std::vector<SupportedBody> joined_;
};

}  // namespace

std::vector<bool> outOfEquilibrium(const std::vector<SupportedBody>& bodies, const std::vector<SupportPoint>& points,
                                   const Vector3& gravity, double friction) {
  const BondedBodies bonded(bodies, points);
  const std::vector<std::size_t>& whole = bonded.whole();
  Balance balance(bonded.joined(), gravity);
  for (SupportPoint at : points) {
    at.a = whole[at.a];
    at.b = whole[at.b];
    if (at.a == at.b) continue;
    const Vector3 along = at.normal.unitOrthogonal();
    const Vector3 across = at.normal.cross(along);
    for (const Vector3& tangent : {along, Vector3(-along), across, Vector3(-across)}) {
      balance.addForce(at, at.normal + friction * tangent);
    }
  }
  const std::vector<double> unbalanced = balance.solve();
  std::vector<bool> out;
  for (const std::size_t body : whole) out.push_back(unbalanced[body] > kUnbalanced);
  return out;
}

}  // namespace glissade
