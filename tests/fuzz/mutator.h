#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/random_stream.h"

namespace glissade::fuzz {

/// Makes malformed inputs out of sound ones: bytes and numbers changed, pieces removed, repeated, moved and taken from
/// another input, words of the format inserted. The n-th input depends on the seed and n alone.
class Mutator {
 public:
  Mutator(std::uint64_t seed, std::vector<std::string> corpus, std::vector<std::string> words);

  std::string input(std::uint64_t number) const;

 private:
  void mutateOnce(RandomStream& random, std::string& text) const;

  std::uint64_t seed_;
  std::vector<std::string> corpus_;
  std::vector<std::string> words_;
};

}  // namespace glissade::fuzz
