#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <array>

namespace glissade::fuzz {
namespace {

constexpr std::size_t kLongest = 1U << 16;

/// Below `count`, which is not 0.
std::size_t below(RandomStream& random, std::size_t count) { return random.bits() % count; }

struct Piece {
  std::size_t begin;
  std::size_t size;
};

/// Mostly short.
Piece pieceOf(RandomStream& random, const std::string& text) {
  if (text.empty()) return {0, 0};
  const std::size_t begin = below(random, text.size());
  const std::size_t most = std::min<std::size_t>(text.size() - begin, below(random, 4) == 0 ? 400 : 12);
  return {begin, 1 + below(random, most)};
}

void replaceNumber(RandomStream& random, std::string& text) {
  static const std::array<const char*, 12> kNumbers{"0",      "-1",    "1e9",        "1e10",
                                                    "1e19",   "1e308", "1e-9",       "1e-13",
                                                    "1e-320", "nan",   "4294967296", "18446744073709551616"};
  const std::size_t from = text.empty() ? 0 : below(random, text.size());
  const std::size_t begin = text.find_first_of("0123456789", from);
  if (begin == std::string::npos) return;
  const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-", begin), text.size());
  text.replace(begin, end - begin, kNumbers[below(random, kNumbers.size())]);
}

}  // namespace

Mutator::Mutator(std::uint64_t seed, std::vector<std::string> corpus, std::vector<std::string> words)
    : seed_(seed), corpus_(std::move(corpus)), words_(std::move(words)) {}

std::string Mutator::input(std::uint64_t number) const {
  RandomStream random(seed_, "mutation " + std::to_string(number));
  std::string text = corpus_[below(random, corpus_.size())];
  for (std::size_t left = 1 + below(random, 5); left > 0; --left) mutateOnce(random, text);
  if (text.size() > kLongest) text.resize(kLongest);
  return text;
}

void Mutator::mutateOnce(RandomStream& random, std::string& text) const {
  const Piece piece = pieceOf(random, text);
  const std::size_t at = text.empty() ? 0 : below(random, text.size() + 1);
  switch (below(random, 9)) {
    case 0:
      if (!text.empty()) text[piece.begin] = static_cast<char>(random.bits());
      break;
    case 1:
      if (!text.empty()) text[piece.begin] = static_cast<char>(text[piece.begin] ^ (1 << below(random, 8)));
      break;
    case 2: text.erase(piece.begin, piece.size); break;
    case 3: text.insert(at, text.substr(piece.begin, piece.size)); break;
    case 4: {
      const std::string repeated = text.substr(piece.begin, std::min<std::size_t>(piece.size, 16));
      for (std::size_t left = below(random, 200); left > 0; --left) text.insert(piece.begin, repeated);
      break;
    }
    case 5: text.resize(at); break;
    case 6: replaceNumber(random, text); break;
    case 7: text.insert(at, words_[below(random, words_.size())]); break;
    default: {
      const std::string& other = corpus_[below(random, corpus_.size())];
      const Piece taken = pieceOf(random, other);
      text.replace(piece.begin, piece.size, other, taken.begin, taken.size);
    }
  }
}

}  // namespace glissade::fuzz
