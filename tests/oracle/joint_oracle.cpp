#include "tests/oracle/joint_oracle.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace glissade::oracle {
namespace {

using Json = nlohmann::json;
using Ids = std::set<std::string>;

constexpr double kPi = 3.14159265358979323846;
/// Largest deviation of the axis from the exact screw motion, as a share of the pitch.
constexpr double kPlay = 0.02;
/// Largest angle of an axis that does not count as tilted, radians.
constexpr double kTilt = 1e-4;

bool hasAny(const Ids& bodies, const std::vector<std::string>& wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& id) { return bodies.count(id) != 0; });
}

/// The step's motion from its beginning: X(t) X(0)^-1.
Placement since(const Placement& start, const Placement& now) {
  const Rotation& a = now.orientation;
  const Rotation b{-start.orientation[0], -start.orientation[1], -start.orientation[2], start.orientation[3]};
  const Rotation turn{
      a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
      a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
  return {now.position - rotated(turn, start.position), turn};
}

/// Adds up the turn about an axis from placement to placement; none may turn by half a circle or more.
class TurnFollower {
 public:
  TurnFollower(const StatedJoint& joint, double sense)
      : point_(joint.point), axis_(sense / length(joint.direction) * joint.direction), pitch_(joint.pitch) {}

  /// The violation at a placement; empty while the motion is the screw motion of the joint.
  std::string follow(const Placement& moved) {
    const auto [x, y, z, w] = moved.orientation;
    const Point vector{x, y, z};
    if (length(cross(rotated(moved.orientation, axis_), axis_)) > kTilt) return "its axis tilts";
    double angle = 2.0 * std::atan2(dot(vector, axis_), w);
    while (angle - turned_ > kPi) angle -= 2.0 * kPi;
    while (angle - turned_ < -kPi) angle += 2.0 * kPi;
    if (std::abs(angle - turned_) > kPi - 1e-6) return "an edge turns by half a circle";
    turned_ = angle;
    const Point way = placed(moved, point_) - point_;
    advance_ = dot(way, axis_);
    if (length(way - advance_ * axis_) > kPlay * std::abs(pitch_)) return "it leaves the axis";
    if (std::abs(advance_ - turned_ / (2.0 * kPi) * pitch_) > kPlay * std::abs(pitch_)) {
      return "it advances by " + std::to_string(1e3 * advance_) + " mm in " + std::to_string(turned_ / (2.0 * kPi)) +
             " turns";
    }
    return {};
  }
  double advance() const { return advance_; }

 private:
  Point point_;
  Point axis_;
  double pitch_;
  double turned_ = 0.0;
  double advance_ = 0.0;
};

class LineJudge {
 public:
  LineJudge(const StatedLine& line, const std::vector<StatedJoint>& joints, std::vector<std::string>& violations)
      : line_(line), joints_(joints), violations_(violations), present_(line.bodies.begin(), line.bodies.end()) {}

  void judge() {
    if (present_.size() != line_.bodies.size()) say("a body is listed twice");
    for (const StatedStep& step : line_.steps) {
      number_ += step.continues ? 0 : 1;
      judgeStep(step);
    }
    number_ = 0;
    countTheRest();
    for (const StatedLine& inner : line_.lines) judgeLine(inner);
  }

 private:
  void say(const std::string& what) {
    const std::string where = line_.step == 0 ? "" : "in the line of step " + std::to_string(line_.step) + ": ";
    violations_.push_back(where + (number_ == 0 ? "" : "step " + std::to_string(number_) + ": ") + what);
  }

  bool isClosed(const StatedJoint& joint) const {
    return present_.count(joint.body) != 0 && hasAny(present_, joint.others);
  }

  void judgeStep(const StatedStep& step) {
    const Ids leaving(step.bodies.begin(), step.bodies.end());
    for (const std::string& id : step.bodies) {
      if (present_.count(id) == 0) say("'" + id + "' has left before, or is none of the bodies");
      if (std::count(line_.staying.begin(), line_.staying.end(), id) != 0) say("'" + id + "' stays");
    }
    if (!step.certified) judgeWithoutProof(step);
    Ids left = present_;
    for (const std::string& id : leaving) left.erase(id);
    judgePulled(step, left);
    for (const StatedJoint& joint : joints_) {
      if (!joint.isScrewed()) continue;
      judgeClamped(joint, leaving);
      if (isClosed(joint) && opens(joint, leaving, left)) judgeOpening(joint, step, leaving);
    }
    present_ = left;
  }

  /// Judges pulled threads, independent of the known joints.
  void judgePulled(const StatedStep& step, const Ids& left) {
    double turned = 0.0;
    for (std::size_t i = 1; i < step.path.size(); ++i) {
      const auto [x, y, z, w] = since(step.path[i - 1], step.path[i]).orientation;
      turned += 2.0 * std::atan2(length(Point{x, y, z}), std::abs(w));
    }
    if (turned >= 2.0 * kPi) return;
    for (const std::string& id : step.threads) {
      if (left.count(id) != 0) say("'" + step.bodies.front() + "' is pulled off the thread of '" + id + "'");
    }
  }

  void judgeWithoutProof(const StatedStep& step) {
    const bool flexible = std::any_of(joints_.begin(), joints_.end(), [&](const StatedJoint& joint) {
      return joint.kind == "flexible" && step.bodies.size() == 1 && joint.body == step.bodies.front();
    });
    if (!flexible) say("'" + step.bodies.front() + "' leaves without a proof, and is not flexible");
  }

  /// True if the two sides of the joint part.
  static bool opens(const StatedJoint& joint, const Ids& leaving, const Ids& left) {
    return leaving.count(joint.body) != 0 ? hasAny(left, joint.others)
                                          : left.count(joint.body) != 0 && hasAny(leaving, joint.others);
  }

  void judgeClamped(const StatedJoint& joint, const Ids& leaving) {
    const bool fastenerStays = present_.count(joint.body) != 0 && leaving.count(joint.body) == 0;
    if (fastenerStays && isClosed(joint) && hasAny(leaving, joint.clamped)) {
      say("what " + joint.kind + " '" + joint.body + "' clamps leaves before it");
    }
    for (const std::string& id : joint.clamped) {
      if (leaving.count(id) != 0 && isClosed(joint)) late_[joint.body].insert(id);
    }
    if (leaving.count(joint.body) == 0) return;
    for (const std::string& id : late_[joint.body]) {
      if (leaving.count(id) == 0) say(joint.kind + " '" + joint.body + "' leaves after '" + id + "', which it clamps");
    }
  }

  /// Judges the opening of a joint. The joint's direction is that in which its fastener leaves.
  void judgeOpening(const StatedJoint& joint, const StatedStep& step, const Ids& leaving) {
    if (joint.pitch == 0.0) return;
    const std::string what = "the thread of " + joint.kind + " '" + joint.body + "' opens, and ";
    TurnFollower follower(joint, leaving.count(joint.body) != 0 ? 1.0 : -1.0);
    for (const Placement& at : step.path) {
      const std::string wrong = follower.follow(since(step.path.front(), at));
      if (!wrong.empty()) {
        say(what + wrong + " before it is free");
        return;
      }
      if (std::abs(follower.advance()) >= joint.travel * (1.0 - 1e-6)) return;
    }
    say(what + "the step ends before it is free");
  }

  void countTheRest() {
    Ids rest = present_;
    for (const auto* ids : {&line_.staying, &line_.stuck}) {
      for (const std::string& id : *ids) {
        if (rest.erase(id) == 0)
          say("'" + id + "' is to remain, and has left, is counted twice or is none of the bodies");
      }
    }
    for (const std::string& id : rest) say("'" + id + "' neither leaves nor stays nor is stuck");
  }

  void judgeLine(const StatedLine& inner) {
    Ids left;
    std::size_t number = 0;
    for (const StatedStep& step : line_.steps) {
      number += step.continues ? 0 : 1;
      if (number == inner.step) left.insert(step.bodies.begin(), step.bodies.end());
    }
    if (left != Ids(inner.bodies.begin(), inner.bodies.end())) say("a line has other bodies than its step");
    LineJudge(inner, joints_, violations_).judge();
  }

  const StatedLine& line_;
  const std::vector<StatedJoint>& joints_;
  std::vector<std::string>& violations_;
  Ids present_;
  std::map<std::string, Ids> late_;  ///< for each fastener: clamped bodies that have left while the thread was closed
  std::size_t number_ = 0;
};

Json parsed(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file + ": cannot be read");
  return Json::parse(stream);
}

std::vector<std::string> idsIn(const Json& object, const char* key) {
  return object.contains(key) ? object.at(key).get<std::vector<std::string>>() : std::vector<std::string>();
}

StatedStep motionIn(const Json& json) {
  StatedStep motion{idsIn(json, "bodies"), {}, json.at("certificate").at("status") == "certified"};
  for (const Json& at : json.at("path")) {
    motion.path.push_back({at.at("position").get<Point>(), at.at("orientation").get<Rotation>()});
  }
  for (const Json& allowance : json.at("allowances")) {
    if (allowance.at("kind") == "thread") motion.threads.push_back(allowance.at("body"));
  }
  return motion;
}

StatedLine lineIn(const Json& json) {
  StatedLine line;
  line.step = json.contains("step") ? json.at("step").get<std::size_t>() : 0;
  line.bodies = idsIn(json, "bodies");
  line.staying = idsIn(json, "staying");
  for (const Json& each : json.at("steps")) {
    const bool isOfVersion1 = !each.contains("motions");
    const Json motions = isOfVersion1 ? Json::array({each}) : each.at("motions");
    for (std::size_t i = 0; i < motions.size(); ++i) {
      line.steps.push_back(motionIn(motions[i]));
      line.steps.back().continues = i > 0;
    }
  }
  for (const Json& each : json.at("stuck")) line.stuck.push_back(each.at("part").get<std::string>());
  for (const Json& each : json.value("lines", Json::array())) line.lines.push_back(lineIn(each));
  return line;
}

}  // namespace

std::vector<std::string> violationsOf(const StatedLine& plan, const std::vector<StatedJoint>& joints) {
  std::vector<std::string> violations;
  LineJudge(plan, joints, violations).judge();
  return violations;
}

std::vector<StatedJoint> readStatedJoints(const std::string& file, bool suggested) {
  std::vector<StatedJoint> joints;
  const Json json = parsed(file);
  for (const Json& each : json.at("joints")) {
    if (!suggested && each.at("state") == "suggested") continue;
    StatedJoint joint{each.at("kind"), each.at("body"), idsIn(each, "others"), idsIn(each, "clamped")};
    joint.point = each.at("point").get<Point>();
    joint.direction = each.at("direction").get<Point>();
    if (each.contains("thread")) {
      const Json& thread = each.at("thread");
      joint.pitch = thread.at("pitch_m");
      joint.travel = std::max(thread.at("engaged_m").get<double>(), thread.value("travel_m", 0.0));
    }
    joints.push_back(std::move(joint));
  }
  return joints;
}

StatedLine readStatedPlan(const std::string& file) { return lineIn(parsed(file)); }

}  // namespace glissade::oracle
