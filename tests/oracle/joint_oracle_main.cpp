// Prints the violations for which an assembler would refuse a plan; with the contacts of the product also those of its
// order. usage: joint_oracle PLAN JOINTS [suggested] [FITS]
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "tests/oracle/joint_oracle.h"
#include "tests/oracle/order_oracle.h"

int main(int count, char** values) {
  using namespace glissade::oracle;
  std::vector<std::string> arguments(values + 1, values + count);
  const bool suggested = arguments.size() > 2 && arguments[2] == "suggested";
  if (suggested) arguments.erase(arguments.begin() + 2);
  if (arguments.size() != 2 && arguments.size() != 3) {
    std::cerr << "usage: joint_oracle PLAN JOINTS [suggested] [FITS]\n";
    return 2;
  }
  try {
    const auto joints = readStatedJoints(arguments[1], suggested);
    const StatedLine plan = readStatedPlan(arguments[0]);
    auto violations = violationsOf(plan, joints);
    if (arguments.size() == 3) {
      const auto ofOrder = orderViolationsOf(plan, joints, readStatedContacts(arguments[2]));
      violations.insert(violations.end(), ofOrder.begin(), ofOrder.end());
    }
    for (const std::string& each : violations) std::cout << each << "\n";
    std::cout << joints.size() << " joints, " << violations.size() << " violations\n";
    return violations.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
}
