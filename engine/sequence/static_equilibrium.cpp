#include "engine/sequence/static_equilibrium.h"

#include <coin/Clp_C_Interface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace glissade {
namespace {

constexpr int kEquations = 6;
constexpr double kUnbalanced = 0.01;
constexpr int kMostIterations = 200'000;

struct ModelDeleter {
  void operator()(Clp_Simplex* model) const { Clp_deleteModel(model); }
};

/// The columns of a linear program, by entries.
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

/// Minimizes the sum of the unbalanced forces and torques. Forces are in units of the mean weight, torques in those of
/// it times the body's size.
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

  /// The force acts on `b`, and against it on `a`.
  void addForce(const SupportPoint& at, const Vector3& force) {
    if (firstRow_[at.a] < 0 && firstRow_[at.b] < 0) return;
    columns_.begin(0.0);
    addWrench(at.b, at.point, force);
    addWrench(at.a, at.point, -force);
  }

  /// Any force and torque between the two.
  void addBond(const SupportPoint& at) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        addForce(at, sign * Vector3::Unit(axis));
        addTorque(at, sign * Vector3::Unit(axis));
      }
    }
  }

  /// What stays unbalanced of each body, in shares of its weight.
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
    const std::unique_ptr<Clp_Simplex, ModelDeleter> model(Clp_newModel());
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
  /// In units of the mean weight times the size of `b`.
  void addTorque(const SupportPoint& at, const Vector3& torque) {
    if (firstRow_[at.a] < 0 && firstRow_[at.b] < 0) return;
    columns_.begin(0.0);
    for (const auto& [body, sign] : {std::pair{at.b, 1.0}, std::pair{at.a, -1.0}}) {
      if (firstRow_[body] < 0) continue;
      const double share = sign * bodies_[at.b].size / bodies_[body].size;
      for (int axis = 0; axis < 3; ++axis) columns_.add(firstRow_[body] + 3 + axis, share * torque[axis]);
    }
  }

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
  std::vector<int> firstRow_;  ///< -1 of a fixed body
  int rowCount_ = 0;
  double unit_ = 1.0;
  std::vector<double> wanted_;
  Columns columns_;
};

}  // namespace

std::vector<bool> outOfEquilibrium(const std::vector<SupportedBody>& bodies, const std::vector<SupportPoint>& points,
                                   const Vector3& gravity, double friction) {
  Balance balance(bodies, gravity);
  for (const SupportPoint& at : points) {
    if (at.bonded) {
      balance.addBond(at);
      continue;
    }
    const Vector3 along = at.normal.unitOrthogonal();
    const Vector3 across = at.normal.cross(along);
    for (const Vector3& tangent : {along, Vector3(-along), across, Vector3(-across)}) {
      balance.addForce(at, at.normal + friction * tangent);
    }
  }
  std::vector<bool> out;
  for (const double share : balance.solve()) out.push_back(share > kUnbalanced);
  return out;
}

}  // namespace glissade
