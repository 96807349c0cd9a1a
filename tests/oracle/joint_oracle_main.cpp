// Prints the violations for which an assembler would refuse a plan. usage: joint_oracle PLAN JOINTS [suggested]
#include <exception>
#include <iostream>
#include <string>

#include "tests/oracle/joint_oracle.h"

int main(int count, char** arguments) {
  using namespace glissade::oracle;
  const std::string last = count == 4 ? arguments[3] : "";
  if (count != 3 && last != "suggested") {
    std::cerr << "usage: joint_oracle PLAN JOINTS [suggested]\n";
    return 2;
  }
  try {
    const auto joints = readStatedJoints(arguments[2], last == "suggested");
    const auto violations = violationsOf(readStatedPlan(arguments[1]), joints);
    for (const std::string& each : violations) std::cout << each << "\n";
    std::cout << joints.size() << " joints, " << violations.size() << " violations\n";
    return violations.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
}
