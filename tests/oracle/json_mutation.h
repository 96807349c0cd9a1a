#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace glissade::oracle {

/// Random numbers that are equal with every standard library.
class MutationDice {
 public:
  MutationDice(std::uint64_t seed, std::uint64_t number) {
    std::seed_seq words{seed, number, std::uint64_t{0x3a7}};
    engine_.seed(words);
  }

  std::size_t below(std::size_t count) { return engine_() % count; }
  bool flip() { return below(2) == 1; }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  /// A size between both bounds; every order of magnitude is equally frequent.
  double magnitude(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  double either(double size) { return flip() ? size : -size; }

 private:
  std::mt19937_64 engine_;
};

using Json = nlohmann::json;

/// Changes a path file (its text as JSON, without a checksum). Returns a description of the change.
std::string mutatePath(Json& path, const std::string& body, MutationDice& dice);

/// Changes an assembly plan. `bodies`: ids of the product. Returns a description of the change.
std::string mutatePlan(Json& plan, const std::vector<std::string>& bodies, MutationDice& dice);

}  // namespace glissade::oracle
