#include "tests/oracle/plan_oracle.h"

#include <algorithm>
#include <map>
#include <set>

#include "tests/oracle/exact_judge.h"
#include "tests/oracle/stated_file.h"

namespace glissade::oracle {
namespace {

using Json = nlohmann::json;

/// Metres; shallower penetrations are left undecided.
constexpr double kDeep = 2e-6;
constexpr int kSamples = 24;

Rotation product(const Rotation& a, const Rotation& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

/// The motion of the world that takes the first pose to the other one.
Placement motionTo(const Placement& pose, const Placement& first) {
  const Rotation& q = first.orientation;
  Placement motion;
  motion.orientation = product(pose.orientation, {-q[0], -q[1], -q[2], q[3]});
  motion.position = pose.position - rotated(motion.orientation, first.position);
  return motion;
}

struct Bounds {
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};

  void add(const Triangles& triangles) {
    for (const Triangle& triangle : triangles) {
      for (const Point& p : triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
          low[i] = std::min(low[i], p[i]);
          high[i] = std::max(high[i], p[i]);
        }
      }
    }
  }
  bool overlaps(const Bounds& other) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (high[i] < other.low[i] + kDeep || other.high[i] < low[i] + kDeep) return false;
    }
    return true;
  }
};

bool isCount(const Json& value, std::size_t count) {
  return value.is_number_integer() && value.get<std::int64_t>() == static_cast<std::int64_t>(count);
}

/// The plan with each motion as a step, which is after the earlier motions of its step.
Json flattened(const Json& plan) {
  Json flat = plan;
  flat["steps"] = Json::array();
  std::vector<Json> numbers;  // of the motions of each step
  for (const Json& step : plan.at("steps")) {
    Json after = Json::array();
    for (const Json& each : step.value("after", Json::array())) {
      const auto number = each.get<std::size_t>();
      const bool isEarlier = number > 0 && number <= numbers.size();
      for (const Json& one : isEarlier ? numbers[number - 1] : Json::array({0})) after.push_back(one);
    }
    Json own = Json::array();
    for (Json motion : step.at("motions")) {
      if (step.contains("after")) motion["after"] = after;
      flat["steps"].push_back(std::move(motion));
      own.push_back(flat["steps"].size());
      after.push_back(flat["steps"].size());
    }
    numbers.push_back(std::move(own));
  }
  return flat;
}

class PlanOracle {
 public:
  PlanOracle(const Json& plan, const std::vector<PlanBody>& product) : plan_(flattened(plan)), product_(product) {
    for (const PlanBody& body : product) bodies_[body.id] = &body;
  }

  std::string whyFalse() {
    if (const std::string why = falseNames(); !why.empty()) return why;
    if (const std::string why = falseCounts(); !why.empty()) return why;
    for (std::size_t i = 0; i < plan_.at("steps").size(); ++i) {
      if (const std::string why = falseStep(i); !why.empty()) return "step " + std::to_string(i + 1) + ": " + why;
    }
    return {};
  }

 private:
  std::string falseNames() {
    std::set<std::string> listed;
    for (const Json& id : plan_.at("bodies")) {
      if (!listed.insert(id.get<std::string>()).second || bodies_.count(id.get<std::string>()) == 0) return "bodies";
    }
    if (listed.size() != bodies_.size()) return "bodies";
    for (const Json& id : plan_.at("staying")) {
      if (bodies_.count(id.get<std::string>()) == 0 || !staying_.insert(id.get<std::string>()).second) return "staying";
    }
    return {};
  }

  std::string falseCounts() {
    const std::size_t parts = bodies_.size() - staying_.size();
    std::set<std::string> left;
    std::size_t removed = 0;
    for (const Json& step : plan_.at("steps")) {
      if (step.at("bodies").empty()) return "a step moves nothing";
      for (const Json& body : step.at("bodies")) {
        const auto id = body.get<std::string>();
        if (bodies_.count(id) == 0 || staying_.count(id) != 0 || !left.insert(id).second) return "who leaves";
        ++removed;
      }
      if (step.at("certificate").at("status") != "certified") return "a step says that it is not certified";
    }
    if (!isCount(plan_.at("parts"), parts) || !isCount(plan_.at("removed"), removed)) return "counts";
    const std::string end = plan_.at("end");
    const std::set<std::string> ends{"complete", "stuck", "time_limit", "interrupted"};
    if (ends.count(end) == 0 || (end == "complete" && (removed < parts || parts == 0))) return "end";
    const Json& deflection = plan_.at("deflection_m");
    if (!deflection.is_number() || std::abs(deflection.get<double>()) > 1e9) return "deflection";
    return plan_.at("certified").get<bool>() ? "" : "not certified";
  }

  /// The bodies of earlier steps. With `all` false, only of steps that come before in every order that keeps `after`.
  std::set<std::string> goneBefore(std::size_t number, bool all) const {
    std::set<std::string> gone;
    std::set<std::size_t> before;
    const Json& steps = plan_.at("steps");
    std::vector<std::size_t> open;
    const auto add = [&](std::size_t of) {
      if (all || !steps[of].contains("after")) {
        for (std::size_t i = 0; i < of; ++i) open.push_back(i);
        return;
      }
      for (const Json& each : steps[of].at("after")) {
        const auto one = each.get<std::size_t>();
        if (one > 0 && one <= of) open.push_back(one - 1);
      }
    };
    for (add(number); !open.empty();) {
      const std::size_t one = open.back();
      open.pop_back();
      if (!before.insert(one).second) continue;
      add(one);
      for (const Json& id : steps[one].at("bodies")) gone.insert(id.get<std::string>());
    }
    return gone;
  }

  std::string falseStep(std::size_t number) const {
    const Json& step = plan_.at("steps")[number];
    if (step.contains("after")) {
      for (const Json& each : step.at("after")) {
        const auto before = each.get<std::size_t>();
        if (before == 0 || before > number) return "it is after no earlier step";
      }
    }
    for (const Json& allowance : step.at("allowances")) {
      const auto metres = statedAllowance(allowance);
      if (!metres) return "an allowance is no length";
      if (allowance.contains("pitch_m") &&
          !(allowance["pitch_m"].is_number() && std::abs(allowance["pitch_m"].get<double>()) < 1e9))
        return "a pitch is no length";
      if (*metres > 0.0) return "an allowance of bodies that are apart";
    }
    const auto path = statedPoses(step.at("path"));
    if (!path) return "a pose is not one";
    Triangles group;
    std::set<std::string> moving;
    for (const Json& id : step.at("bodies")) {
      const Triangles& own = bodies_.at(id.get<std::string>())->triangles;
      group.insert(group.end(), own.begin(), own.end());
      moving.insert(id.get<std::string>());
    }
    return endsWithin(number, group, moving, *path) ? "it ends among the others"
                                                    : collision(number, group, moving, *path);
  }

  bool endsWithin(std::size_t number, const Triangles& group, const std::set<std::string>& moving,
                  const std::vector<Placement>& path) const {
    Bounds own;
    own.add(placed(motionTo(path.back(), path.front()), group));
    Bounds others;
    const std::set<std::string> gone = goneBefore(number, true);
    for (const PlanBody& body : product_) {
      if (gone.count(body.id) == 0 && moving.count(body.id) == 0) others.add(body.triangles);
    }
    return own.overlaps(others);
  }

  std::string collision(std::size_t number, const Triangles& group, const std::set<std::string>& moving,
                        const std::vector<Placement>& path) const {
    const std::set<std::string> gone = goneBefore(number, false);
    for (const PlanBody& body : product_) {
      if (gone.count(body.id) != 0 || moving.count(body.id) != 0) continue;
      const ExactJudge judge({{body.triangles}, group});
      for (std::size_t edge = 0; edge + 1 < path.size(); ++edge) {
        for (int i = 0; i <= kSamples; ++i) {
          const Placement pose = between(path[edge], path[edge + 1], static_cast<double>(i) / kSamples);
          const Placement motion = motionTo(pose, path.front());
          if (judge.penetrates(motion) && judge.depthAt(motion) > kDeep) return "it meets " + body.id;
        }
      }
    }
    return {};
  }

  const Json plan_;
  const std::vector<PlanBody>& product_;
  std::map<std::string, const PlanBody*> bodies_;
  std::set<std::string> staying_;
};

}  // namespace

std::string whyFalse(const Json& plan, const std::vector<PlanBody>& product) {
  return PlanOracle(plan, product).whyFalse();
}

}  // namespace glissade::oracle
