// Gives mutated inputs to the readers of all formats and counts the defects.
//
// usage: mutate_readers CORPUS [--target NAME] [--inputs mutations|truncations] [--mutations N] [--seconds S]
//                       [--seed S] [--keep FOLDER]
//
// CORPUS has a folder of valid files for each target. truncations: every beginning of every file instead of mutations.
// --seconds ends each target's run early. --keep writes the inputs that are defects. Prints one row for each target:
//   name | tried | clean | defects | seconds | peak MB | seed
// A defect is an input on which the reader crashes, breaks the contract (targets.h), takes more than 10 s or more than
// 2 GB. Exit code 1: there are defects.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/random_stream.h"
#include "tests/fuzz/targets.h"

#ifdef GLISSADE_SANITIZED
extern "C" const char* __ubsan_default_options();
extern "C" const char* __ubsan_default_options() { return "halt_on_error=1:abort_on_error=1:print_stacktrace=1"; }
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "hard_rss_limit_mb=2048:detect_leaks=0:abort_on_error=1"; }
#endif

namespace {

namespace fs = std::filesystem;
using glissade::RandomStream;
using glissade::fuzz::Target;

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

using Clock = std::chrono::steady_clock;

constexpr unsigned kPatienceSeconds = 10;

struct Options {
  std::string corpus;
  std::string target;  ///< empty: all
  bool truncations = false;
  std::uint64_t mutations = 10'000;
  double seconds = 1e9;
  std::uint64_t seed = 1;
  std::string keep;
};

struct Count {
  std::uint64_t tried = 0;
  std::uint64_t defects = 0;
  double seconds = 0.0;
  long peakKilobytes = 0;
};

/// Memory that parent and child share.
struct Shared {
  std::uint64_t next = 0;  ///< index of the present input, or of the first one not tried
};

/// Inputs of a reader, by number.
struct Inputs {
  std::uint64_t count;
  std::function<std::string(std::uint64_t)> at;
};

Inputs mutationsOf(const Target& target, const std::vector<std::string>& corpus, const Options& options) {
  const auto mutator = std::make_shared<const Mutator>(options.seed, corpus, target.words);
  return {options.mutations, [mutator](std::uint64_t number) { return mutator->input(number); }};
}

Inputs truncationsOf(const std::vector<std::string>& corpus) {
  std::uint64_t count = 0;
  for (const std::string& file : corpus) count += file.size();
  return {count, [corpus](std::uint64_t number) {
            auto file = corpus.begin();
            for (; number >= file->size(); ++file) number -= file->size();
            return file->substr(0, number);
          }};
}

std::string contentOf(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

std::vector<std::string> corpusOf(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> corpus;
  for (const fs::path& file : files) corpus.push_back(contentOf(file));
  return corpus;
}

[[noreturn]] void tryInputs(const Target& target, const Inputs& inputs, Clock::time_point deadline, Shared& shared) {
  while (shared.next < inputs.count && Clock::now() < deadline) {
    ::alarm(kPatienceSeconds);
    target.run(inputs.at(shared.next));
    ++shared.next;
  }
  ::_exit(0);
}

void keepInput(const std::string& folder, const std::string& name, std::uint64_t number, const std::string& input) {
  if (folder.empty()) return;
  fs::create_directories(folder);
  std::ofstream(fs::path(folder) / (name + "-" + std::to_string(number)), std::ios::binary) << input;
}

/// Runs the inputs. Each defect ends a child; the next child continues behind it.
Count run(const Target& target, const Inputs& inputs, const Options& options, Shared& shared) {
  const auto begin = Clock::now();
  const auto deadline =
      begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds));
  Count count;
  shared.next = 0;
  while (shared.next < inputs.count && Clock::now() < deadline) {
    const pid_t child = ::fork();
    if (child == 0) tryInputs(target, inputs, deadline, shared);
    if (child < 0) break;
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    count.peakKilobytes = std::max(count.peakKilobytes, usage.ru_maxrss);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
    std::cerr << target.name << ": input " << shared.next << " of seed " << options.seed << " is a defect ("
              << (WIFSIGNALED(status) ? ::strsignal(WTERMSIG(status)) : "the reader ended the process") << ")\n";
    keepInput(options.keep, target.name, shared.next, inputs.at(shared.next));
    ++count.defects;
    ++shared.next;
  }
  count.tried = shared.next;
  count.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return count;
}

std::optional<Options> optionsOf(int argc, char** argv) {
  Options options;
  if (argc < 2 || argc % 2 != 0) return std::nullopt;
  options.corpus = argv[1];
  for (int i = 2; i < argc; i += 2) {
    const std::string name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "--target") options.target = value;
    if (name == "--inputs") options.truncations = value == "truncations";
    if (name == "--mutations") options.mutations = std::stoull(value);
    if (name == "--seconds") options.seconds = std::stod(value);
    if (name == "--seed") options.seed = std::stoull(value);
    if (name == "--keep") options.keep = value;
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = optionsOf(argc, argv);
  if (!options) {
    std::cerr << "usage: mutate_readers CORPUS [--target NAME] [--inputs mutations|truncations] [--mutations N] "
                 "[--seconds S] "
                 "[--seed S] [--keep FOLDER]\n";
    return 2;
  }
  void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 2;
  auto* shared = new (memory) Shared;
  bool clean = true;
  for (const Target& target : glissade::fuzz::targets()) {
    if (!options->target.empty() && options->target != target.name) continue;
    const std::vector<std::string> corpus = corpusOf(fs::path(options->corpus) / target.name);
    if (corpus.empty()) {
      std::cerr << "no corpus for " << target.name << " in " << options->corpus << "\n";
      return 2;
    }
    for (const std::string& sound : corpus) {
      const std::string refused = target.run(sound);
      if (refused.empty()) continue;
      std::cerr << "an input of the corpus of " << target.name << " is refused: " << refused << "\n";
      return 2;
    }
    const Inputs inputs = options->truncations ? truncationsOf(corpus) : mutationsOf(target, corpus, *options);
    const Count count = run(target, inputs, *options, *shared);
    std::printf("%s of %s | %llu | %llu | %llu | %.1f | %ld | %llu\n",
                options->truncations ? "every truncation in memory" : "mutations in memory", target.name.c_str(),
                static_cast<unsigned long long>(count.tried),
                static_cast<unsigned long long>(count.tried - count.defects),
                static_cast<unsigned long long>(count.defects), count.seconds, count.peakKilobytes / 1024,
                static_cast<unsigned long long>(options->seed));
    std::fflush(stdout);
    clean = clean && count.defects == 0;
  }
  return clean ? 0 : 1;
}
