#pragma once

#include <map>
#include <set>
#include <string>

namespace glissade {

/// Names that are each given once: the second "pin" is "pin#2".
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
  std::map<std::string, int> numbers_;  ///< the last one of each name that was given several times
};

}  // namespace glissade
