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
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "tests/fuzz/mutator.h"
#include "tests/fuzz/targets.h"

#ifdef GLISSADE_SANITIZED
extern "C" const char* __ubsan_default_options();
extern "C" const char* __ubsan_default_options() { return "halt_on_error=1:abort_on_error=1:print_stacktrace=1"; }
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "hard_rss_limit_mb=2048:detect_leaks=0:abort_on_error=1"; }
#endif

namespace {

namespace fs = std::filesystem;
using glissade::fuzz::Mutator;
using glissade::fuzz::Target;
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
