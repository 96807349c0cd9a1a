#include "engine/check/standard_pitch.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <vector>

#include "engine/geometry/thread_standards.h"

namespace glissade::check {
namespace {

/// Families of threads whose pitches are standard. Wood screws have other pitches, too.
constexpr std::array kFamilies{ThreadFamily::Metric, ThreadFamily::Unified, ThreadFamily::Tapping, ThreadFamily::Pipe,
                               ThreadFamily::Trapezoidal};

/// Relative deviation of a stated pitch from a standard one.
constexpr double kPitchShare = 0.02;
/// Largest depth of a thread of 60 degrees, in pitches, as a difference of diameters.
constexpr double kDepthInPitches = 1.3;
constexpr double kOutside = 1.1;

bool isThread(double nominal, double standardPitch, double diameter, double pitch) {
  return standardPitch > 0.0 && std::abs(pitch - standardPitch) <= kPitchShare * standardPitch &&
         diameter >= nominal - kDepthInPitches * standardPitch && diameter <= kOutside * nominal;
}

/// Runs of letters and digits, in lower case.
std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

/// "m10x1" or "screw": the left hand of a part without a thread, such as a bracket, is ignored.
bool isOfThread(const std::string& word) {
  constexpr std::array<std::string_view, 10> kWords{"screw",    "bolt",   "nut", "thread",       "threaded",
                                                    "schraube", "mutter", "vis", "linksgewinde", "stud"};
  if (std::find(kWords.begin(), kWords.end(), word) != kWords.end()) return true;
  return word.size() > 1 && word[0] == 'm' && std::isdigit(static_cast<unsigned char>(word[1])) != 0;
}

}  // namespace

bool isStandardPitch(double diameter, double pitch) {
  const double advance = std::abs(pitch);
  const auto isOf = [&](const ThreadSize& size) {
    const auto isIt = [&](double standard) { return isThread(size.diameter, standard, diameter, advance); };
    return isIt(size.pitch) || std::any_of(size.finePitches.begin(), size.finePitches.end(), isIt);
  };
  const auto isOfFamily = [&](ThreadFamily family) {
    const std::vector<ThreadSize>& sizes = threadSizes(family);
    return std::any_of(sizes.begin(), sizes.end(), isOf);
  };
  const auto isMetric = [&](double standard) { return isThread(diameter, standard, diameter, advance); };
  const std::vector<double> metric = metricPitches(diameter);
  return std::any_of(kFamilies.begin(), kFamilies.end(), isOfFamily) ||
         std::any_of(metric.begin(), metric.end(), isMetric);
}

bool saysLeftHanded(const std::string& name) {
  const std::vector<std::string> words = wordsOf(name);
  const auto isOneOfWords = [](const std::string& word, const auto& list) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  constexpr std::array<std::string_view, 4> kLeft{"lh", "lefthand", "lefthanded", "linksgewinde"};
  constexpr std::array<std::string_view, 4> kHand{"hand", "handed", "thread", "threaded"};
  bool isLeft = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool isTwoWords = words[i] == "left" && i + 1 < words.size() && isOneOfWords(words[i + 1], kHand);
    isLeft = isLeft || isTwoWords || isOneOfWords(words[i], kLeft);
  }
  return isLeft && std::any_of(words.begin(), words.end(), isOfThread);
}

}  // namespace glissade::check
