#pragma once

#include <map>
#include <set>
#include <string>

namespace glissade {

/// Makes names unique: the second "pin" is "pin#2".
class UniqueNames {
 public:
  std::string take(const std::string& name) {
    if (taken_.insert(name).second) return name;
    int& number = numbers_.try_emplace(name, 1).first->second;
    std::string unique;
    do {
      unique = name + "#" + std::to_string(++number);
    } while (!taken_.insert(unique).second);
    return unique;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> numbers_;  ///< last number of each name that was used several times
};

}  // namespace glissade
