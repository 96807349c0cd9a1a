#include "tests/reliability/mutations.h"

#include <array>
#include <cctype>

namespace glissade::reliability {
namespace {

constexpr std::array<const char*, 18> kNumbers{"nan",  "inf", "-inf", "1e400",      "1e39",       "-1",
                                               "0",    "",    "x",    "4294967295", "2147483648", "1e-400",
                                               "1e19", "--1", "1,5",  "0x10",       "99999999",   "-0.0"};
constexpr std::array<const char*, 8> kPieces{
    "<!DOCTYPE x [<!ENTITY a \"b\">]>", "&a;", "\"", "\\u0000", "\xff\xfe", "\0", "{", "../../../etc/passwd"};

class Mutator {
 public:
  Mutator(std::string text, std::mt19937_64& engine) : text_(std::move(text)), engine_(engine) {}

  std::string run() {
    const std::size_t changes = 1 + below(3);
    for (std::size_t i = 0; i < changes && !text_.empty(); ++i) change();
    return text_;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : engine_() % n; }

  void change() {
    switch (below(11)) {
      case 0: text_[below(text_.size())] ^= static_cast<char>(1U << below(8)); break;
      case 1: text_.erase(below(text_.size()), 1 + below(64)); break;
      case 2: {
        const std::size_t at = below(text_.size());
        text_.insert(at, text_.substr(at, 1 + below(200)));
        break;
      }
      case 3: text_.resize(below(text_.size())); break;
      case 4: writeWord(); break;
      case 5: text_.insert(below(text_.size()), kPieces[below(kPieces.size())]); break;
      case 6: text_.insert(below(text_.size()), std::string(1 + below(100'000), "[{(<a \n0"[below(8)])); break;
      case 7: moveLine(); break;
      default: replaceNumber();
    }
  }

  /// Four bytes, as binary formats hold counts and offsets.
  void writeWord() {
    constexpr std::array<std::uint32_t, 5> kWords{0U, 0xFFFFFFFFU, 0x7FFFFFFFU, 0x10000000U, 0x7FC00000U};
    const std::uint32_t word = kWords[below(kWords.size())];
    const std::size_t at = below(text_.size());
    for (std::size_t i = 0; i < 4 && at + i < text_.size(); ++i) text_[at + i] = static_cast<char>(word >> (8 * i));
  }

  void moveLine() {
    const std::size_t at = text_.rfind('\n', below(text_.size()));
    const std::size_t begin = at == std::string::npos ? 0 : at + 1;
    const std::size_t end = text_.find('\n', begin);
    const std::string line = text_.substr(begin, end == std::string::npos ? end : end - begin + 1);
    if (below(2) == 0) text_.erase(begin, line.size());
    text_.insert(below(text_.size()), line);
  }

  void replaceNumber() {
    const std::size_t from = below(text_.size());
    std::size_t begin = from;
    while (begin < text_.size() && std::isdigit(static_cast<unsigned char>(text_[begin])) == 0) ++begin;
    std::size_t end = begin;
    while (end < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '.'))
      ++end;
    text_.replace(begin, end - begin, kNumbers[below(kNumbers.size())]);
  }

  std::string text_;
  std::mt19937_64& engine_;
};

}  // namespace

std::string mutated(const std::string& good, std::mt19937_64& engine) { return Mutator(good, engine).run(); }

}  // namespace glissade::reliability
