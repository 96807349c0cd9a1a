#include "engine/files/unit_guess.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace glissade {
namespace {

constexpr double kMillimetre = 0.001;

/// Diagonals of bounding boxes, in units of the files.
struct Extent {
  double smallest = std::numeric_limits<double>::infinity();
  double all = 0.0;
};

Extent extentOf(const std::vector<Box3>& inFile) {
  Extent extent;
  Box3 all;
  for (const Box3& box : inFile) {
    extent.smallest = std::min(extent.smallest, box.diagonal().norm());
    all.extend(box);
  }
  extent.all = all.isEmpty() ? 0.0 : all.diagonal().norm();
  return extent;
}

bool fits(const Extent& extent, double unit) {
  constexpr double kSmallestPart = 0.0005;
  constexpr double kLargestProduct = 50.0;
  return extent.smallest * unit >= kSmallestPart && extent.all * unit <= kLargestProduct;
}

std::string sizeOf(const Box3& box) {
  const Vector3 size = box.sizes();
  const auto rounded = [](double value) {
    constexpr int kDigits = 4;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, kDigits);
    return std::string(text.begin(), end.ptr);
  };
  return rounded(size.x()) + " x " + rounded(size.y()) + " x " + rounded(size.z());
}

Diagnostic warningOf(const UnitGuess& guess, const std::string& file, const Box3& box, std::size_t files) {
  const bool millimetres = guess.unit == kMillimetre;
  std::vector<Message> reasons{{GLISSADE_TEXT("does not say its unit; its size is %1"), {sizeOf(box)}}};
  reasons.emplace_back(millimetres ? GLISSADE_TEXT("it is taken in millimetres")
                                   : GLISSADE_TEXT("it is taken in metres"));
  if (guess.inDoubt) reasons.emplace_back(GLISSADE_TEXT("the size does not decide this"));
  if (files > 1) reasons.push_back({GLISSADE_TEXT("other files taken in the same way: %1"), {files - 1}});
  return {ErrorKind::MalformedInput, file, "", joined(reasons, "; "),
          millimetres ? GLISSADE_TEXT("Give the unit: --unit 1mm, or --unit 1m.")
                      : GLISSADE_TEXT("Give the unit: --unit 1m, or --unit 1mm.")};
}

}  // namespace

UnitGuess guessUnit(const std::vector<Box3>& inFile) {
  constexpr double kSurelyMillimetres = 20.0;
  const Extent extent = extentOf(inFile);
  const bool millimetres = fits(extent, kMillimetre);
  const bool metres = fits(extent, 1.0);
  if (millimetres) return {kMillimetre, metres && extent.all < kSurelyMillimetres};
  return metres ? UnitGuess{1.0, false} : UnitGuess{kMillimetre, true};
}

Result<Warnings> guessUnits(std::vector<PartFile>& parts, GeometryCache& read, const StopToken& stop) {
  std::vector<Box3> boxes;
  std::vector<PartFile*> guessed;
  std::vector<std::string> paths;
  for (const PartFile& part : parts) paths.push_back(part.path);
  readSmallFiles(paths, read, stop);
  for (PartFile& part : parts) {
    if (!saysNoUnit(part.path)) continue;
    const auto measured = partsInFile(part.path, read, stop);
    if (!measured) return measured.error();
    boxes.push_back(measured->front().inFile);
    guessed.push_back(&part);
  }
  if (guessed.empty()) return Warnings();
  const UnitGuess guess = guessUnit(boxes);
  for (PartFile* part : guessed) part->unit = guess.unit;
  if (!guess.inDoubt && guess.unit == kMillimetre) return Warnings();
  return Warnings{warningOf(guess, guessed.front()->path, boxes.front(), guessed.size())};
}

}  // namespace glissade
