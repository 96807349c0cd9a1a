#include "tests/oracle/order_oracle.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace glissade::oracle {
namespace {

using Ids = std::set<std::string>;
using Touching = std::map<std::string, Ids>;

Touching touchingOf(const std::vector<StatedJoint>& joints, const StatedContacts& contacts) {
  Touching touching;
  const auto add = [&](const std::string& one, const std::string& other) {
    touching[one].insert(other);
    touching[other].insert(one);
  };
  for (const auto& [one, other] : contacts) add(one, other);
  for (const StatedJoint& joint : joints) {
    for (const std::string& other : joint.others) add(joint.body, other);
    for (const std::string& clamped : joint.clamped) add(joint.body, clamped);
  }
  return touching;
}

/// Judges the steps of a plan or a line; a step's number is its place in the order of removal, from 1.
class OrderJudge {
 public:
  OrderJudge(const StatedLine& line, const std::vector<StatedJoint>& joints, const Touching& touching)
      : line_(line), joints_(joints), touching_(touching) {}

  std::vector<std::string> violations() {
    const Ids all(line_.bodies.begin(), line_.bodies.end());
    Ids there = all;
    for (std::size_t i = 0; i < line_.steps.size(); ++i) {
      const std::vector<std::string>& leaving = line_.steps[i].bodies;
      for (const std::string& id : leaving) there.erase(id);
      if (!touchesAny(leaving, all) || touchesAny(leaving, there)) continue;
      say(i, "puts '" + leaving[0] + "' into the air");
    }
    for (const StatedJoint& joint : joints_) {
      if (joint.kind == "nut") judgeStack(joint);
    }
    return violations_;
  }

 private:
  /// `motion`: its index in the line.
  void say(std::size_t motion, const std::string& what) {
    const auto end = line_.steps.begin() + static_cast<std::ptrdiff_t>(motion) + 1;
    const auto number = std::count_if(line_.steps.begin(), end, [](const StatedStep& step) { return !step.continues; });
    const std::string where = line_.step == 0 ? "" : "in the line of step " + std::to_string(line_.step) + ": ";
    violations_.push_back(where + "step " + std::to_string(number) + " " + what);
  }

  /// True if one of the bodies touches a body of the set that is none of them.
  bool touchesAny(const std::vector<std::string>& bodies, const Ids& set) const {
    const Ids own(bodies.begin(), bodies.end());
    return std::any_of(bodies.begin(), bodies.end(), [&](const std::string& id) {
      const auto known = touching_.find(id);
      return known != touching_.end() &&
             std::any_of(known->second.begin(), known->second.end(),
                         [&](const auto& other) { return set.count(other) != 0 && own.count(other) == 0; });
    });
  }

  /// Index of the motion of the body; the number of motions if it does not leave alone.
  std::size_t motionOf(const std::string& id) const {
    const auto found = std::find_if(line_.steps.begin(), line_.steps.end(), [&](const StatedStep& step) {
      return step.bodies == std::vector<std::string>{id};
    });
    return static_cast<std::size_t>(found - line_.steps.begin());
  }

  void judgeStack(const StatedJoint& nut) {
    for (const std::string& bolt : nut.others) {
      const auto [first, last] = std::minmax({motionOf(nut.body), motionOf(bolt)});
      if (last >= line_.steps.size()) continue;
      for (std::size_t i = first + 1; i < last; ++i) {
        const std::string& between = line_.steps[i].bodies.front();
        const bool isOwn = std::count(nut.clamped.begin(), nut.clamped.end(), between) != 0 || isOn(bolt, between);
        if (isOwn) continue;
        say(i, "puts '" + between + "' between '" + nut.body + "' and '" + bolt + "'");
        return;
      }
      if (last == first + 1 && !line_.steps[last].continues) {
        say(last, "is not one with the step of '" + line_.steps[first].bodies.front() + "'");
      }
    }
  }

  /// True if the body is another nut of the bolt, or clamped by one.
  bool isOn(const std::string& bolt, const std::string& body) const {
    return std::any_of(joints_.begin(), joints_.end(), [&](const StatedJoint& joint) {
      const bool ofBolt = std::count(joint.others.begin(), joint.others.end(), bolt) != 0;
      return ofBolt && (joint.body == body || std::count(joint.clamped.begin(), joint.clamped.end(), body) != 0);
    });
  }

  const StatedLine& line_;
  const std::vector<StatedJoint>& joints_;
  const Touching& touching_;
  std::vector<std::string> violations_;
};

void judge(const StatedLine& line, const std::vector<StatedJoint>& joints, const Touching& touching,
           std::vector<std::string>& violations) {
  for (std::string& each : OrderJudge(line, joints, touching).violations()) violations.push_back(std::move(each));
  for (const StatedLine& inner : line.lines) judge(inner, joints, touching, violations);
}

}  // namespace

std::vector<std::string> orderViolationsOf(const StatedLine& plan, const std::vector<StatedJoint>& joints,
                                           const StatedContacts& contacts) {
  std::vector<std::string> violations;
  judge(plan, joints, touchingOf(joints, contacts), violations);
  return violations;
}

StatedContacts readStatedContacts(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file + ": cannot be read");
  StatedContacts contacts;
  const auto json = nlohmann::json::parse(stream);
  for (const auto& pair : json.at("pairs")) {
    if (pair.at("kind") != "clearance") contacts.emplace_back(pair.at("a"), pair.at("b"));
  }
  return contacts;
}

}  // namespace glissade::oracle
