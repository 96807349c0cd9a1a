#include "engine/check/standard_pitch.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <vector>

namespace glissade::check {
namespace {

/// Sizes in millimetres; 0: no further pitch.
struct MetricThread {
  double diameter;
  std::array<double, 5> pitches;
};

constexpr std::array<MetricThread, 39> kMetric{{{1.0, {0.25, 0.2}},
                                                {1.1, {0.25, 0.2}},
                                                {1.2, {0.25, 0.2}},
                                                {1.4, {0.3, 0.2}},
                                                {1.6, {0.35, 0.2}},
                                                {1.8, {0.35, 0.2}},
                                                {2.0, {0.4, 0.25}},
                                                {2.2, {0.45, 0.25}},
                                                {2.5, {0.45, 0.35}},
                                                {3.0, {0.5, 0.35}},
                                                {3.5, {0.6, 0.35}},
                                                {4.0, {0.7, 0.5}},
                                                {4.5, {0.75, 0.5}},
                                                {5.0, {0.8, 0.5}},
                                                {6.0, {1.0, 0.75, 0.5}},
                                                {7.0, {1.0, 0.75, 0.5}},
                                                {8.0, {1.25, 1.0, 0.75, 0.5}},
                                                {9.0, {1.25, 1.0, 0.75}},
                                                {10.0, {1.5, 1.25, 1.0, 0.75}},
                                                {11.0, {1.5, 1.0, 0.75}},
                                                {12.0, {1.75, 1.5, 1.25, 1.0}},
                                                {14.0, {2.0, 1.5, 1.25, 1.0}},
                                                {16.0, {2.0, 1.5, 1.0}},
                                                {18.0, {2.5, 2.0, 1.5, 1.0}},
                                                {20.0, {2.5, 2.0, 1.5, 1.0}},
                                                {22.0, {2.5, 2.0, 1.5, 1.0}},
                                                {24.0, {3.0, 2.0, 1.5, 1.0}},
                                                {27.0, {3.0, 2.0, 1.5, 1.0}},
                                                {30.0, {3.5, 3.0, 2.0, 1.5, 1.0}},
                                                {33.0, {3.5, 3.0, 2.0, 1.5}},
                                                {36.0, {4.0, 3.0, 2.0, 1.5}},
                                                {39.0, {4.0, 3.0, 2.0, 1.5}},
                                                {42.0, {4.5, 4.0, 3.0, 2.0, 1.5}},
                                                {45.0, {4.5, 4.0, 3.0, 2.0, 1.5}},
                                                {48.0, {5.0, 4.0, 3.0, 2.0, 1.5}},
                                                {52.0, {5.0, 4.0, 3.0, 2.0, 1.5}},
                                                {56.0, {5.5, 4.0, 3.0, 2.0, 1.5}},
                                                {60.0, {5.5, 4.0, 3.0, 2.0, 1.5}},
                                                {64.0, {6.0, 4.0, 3.0, 2.0, 1.5}}}};

/// Pitches of threads that are wider than the table, millimetres.
constexpr std::array<double, 5> kWidePitches{6.0, 4.0, 3.0, 2.0, 1.5};

/// Sizes in millimetres.
struct OtherThread {
  double diameter;
  double pitch;
};

constexpr double kInch = 25.4;
constexpr OtherThread unified(double inches, double threadsOfAnInch) {
  return {kInch * inches, kInch / threadsOfAnInch};
}

constexpr std::array kOthers{
    // Coarse and fine unified threads.
    unified(0.06, 80), unified(0.073, 64), unified(0.073, 72), unified(0.086, 56), unified(0.086, 64),
    unified(0.099, 48), unified(0.099, 56), unified(0.112, 40), unified(0.112, 48), unified(0.125, 40),
    unified(0.125, 44), unified(0.138, 32), unified(0.138, 40), unified(0.164, 32), unified(0.164, 36),
    unified(0.19, 24), unified(0.19, 32), unified(0.216, 24), unified(0.216, 28), unified(0.25, 20), unified(0.25, 28),
    unified(0.3125, 18), unified(0.3125, 24), unified(0.375, 16), unified(0.375, 24), unified(0.4375, 14),
    unified(0.4375, 20), unified(0.5, 13), unified(0.5, 20), unified(0.5625, 12), unified(0.5625, 18),
    unified(0.625, 11), unified(0.625, 18), unified(0.75, 10), unified(0.75, 16), unified(0.875, 9), unified(0.875, 14),
    unified(1.0, 8), unified(1.0, 12),
    // Pipe threads.
    OtherThread{7.723, 0.907}, OtherThread{9.728, 0.907}, OtherThread{13.157, 1.337}, OtherThread{16.662, 1.337},
    OtherThread{20.955, 1.814}, OtherThread{26.441, 1.814}, OtherThread{33.249, 2.309}, OtherThread{41.91, 2.309},
    OtherThread{47.803, 2.309}, OtherThread{59.614, 2.309},
    // Trapezoidal threads.
    OtherThread{8, 1.5}, OtherThread{10, 2}, OtherThread{12, 3}, OtherThread{14, 3}, OtherThread{16, 4},
    OtherThread{18, 4}, OtherThread{20, 4}, OtherThread{24, 5}, OtherThread{28, 5}, OtherThread{32, 6},
    OtherThread{36, 6}, OtherThread{40, 7}, OtherThread{50, 8}, OtherThread{60, 9},
    // Tapping screws.
    OtherThread{2.2, 0.8}, OtherThread{2.9, 1.1}, OtherThread{3.5, 1.3}, OtherThread{3.9, 1.3}, OtherThread{4.2, 1.4},
    OtherThread{4.8, 1.6}, OtherThread{5.5, 1.8}, OtherThread{6.3, 1.8}, OtherThread{8.0, 2.1}};

/// Relative deviation of a stated pitch from a standard one.
constexpr double kPitchShare = 0.02;
/// Largest depth of a thread of 60 degrees, in pitches, as a difference of diameters.
constexpr double kDepthInPitches = 1.3;
constexpr double kOutside = 1.1;

/// All lengths in millimetres.
bool isThread(double nominal, double standardPitch, double diameter, double pitch) {
  return standardPitch > 0.0 && std::abs(pitch - standardPitch) <= kPitchShare * standardPitch &&
         diameter >= nominal - kDepthInPitches * standardPitch && diameter <= kOutside * nominal;
}

bool isOneOf(const std::array<double, 5>& pitches, double nominal, double diameter, double pitch) {
  return std::any_of(pitches.begin(), pitches.end(),
                     [&](double standard) { return isThread(nominal, standard, diameter, pitch); });
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
  const double across = 1e3 * diameter;
  const double advance = 1e3 * std::abs(pitch);
  return std::any_of(kMetric.begin(), kMetric.end(),
                     [&](const MetricThread& each) { return isOneOf(each.pitches, each.diameter, across, advance); }) ||
         std::any_of(kOthers.begin(), kOthers.end(),
                     [&](const OtherThread& each) { return isThread(each.diameter, each.pitch, across, advance); }) ||
         (across > kMetric.back().diameter && isOneOf(kWidePitches, across, across, advance));
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
