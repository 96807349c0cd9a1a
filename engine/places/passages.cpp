#include "engine/places/passages.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
namespace {

/// A doorway is at most half as large as what lies on both sides of it.
constexpr double kLeastContraction = 2.0;
/// A passage longer than wide is a corridor, a place by its narrowness, unless it is this much tighter.
constexpr double kTightContraction = 8.0;
/// Slices belong to the doorway while their section is below this multiple of the narrowest.
constexpr double kSameSection = 1.5;
/// Less than this many cells in section cannot be distinguished from the roughness of the cells.
constexpr int kLeastSection = 4;
constexpr int kMostRounds = 12;

/// A connected part of one slice of the free space.
struct Section {
  std::size_t firstCell = 0;  ///< of Slices' cells
  std::size_t endCell = 0;
  std::vector<int> before;  ///< sections of the slice before that share a face with this one
  std::vector<int> after;

  double area() const { return static_cast<double>(endCell - firstCell); }
};

void addOnce(std::vector<int>& list, int value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

/// The sections of all slices across one axis and how they hang together. Used for several rounds, because memory that
/// is taken anew each time costs as much as the search.
class Slices {
 public:
  Slices(const CellGrid& grid, int axis) : grid_(grid), axis_(axis) {}

  /// The doorways of the open cells. Unfinished after a stop.
  std::vector<Passage> passages(const std::vector<char>& open, const StopToken& stop) {
    findSections(open, stop);
    connectSections();
    std::vector<Passage> found;
    for (int s = 0; s < static_cast<int>(sections_.size()); ++s) {
      if (isChainStart(s)) searchChain(chainFrom(s), found);
    }
    return found;
  }

 private:
  std::size_t a() const { return static_cast<std::size_t>(axis_); }
  Section& section(int id) { return sections_[static_cast<std::size_t>(id)]; }

  void findSections(const std::vector<char>& open, const StopToken& stop) {
    sectionOf_.assign(grid_.size(), kNoSection);
    cells_.clear();
    sections_.clear();
    for (std::size_t cell = 0; cell < grid_.size(); ++cell) {
      if (open[cell] == 0 || sectionOf_[cell] != kNoSection) continue;
      if (stop.stopRequested()) return;
      flood(cell, open);
    }
  }

  /// Adds the section that holds a cell.
  void flood(std::size_t seed, const std::vector<char>& open) {
    const int id = static_cast<int>(sections_.size());
    const std::size_t first = cells_.size();
    const auto add = [&](std::size_t cell) {
      if (open[cell] == 0 || sectionOf_[cell] != kNoSection) return;
      sectionOf_[cell] = id;
      cells_.push_back(cell);
    };
    add(seed);
    for (std::size_t i = first; i < cells_.size(); ++i) grid_.forEachNeighbourAcross(axis_, cells_[i], add);
    sections_.push_back({first, cells_.size(), {}, {}});
  }

  void connectSections() {
    const std::size_t stride = grid_.stride(axis_);
    for (std::size_t cell = 0; cell < grid_.size(); ++cell) {
      if (sectionOf_[cell] == kNoSection || grid_.coordinates(cell)[a()] + 1 >= grid_.counts[a()]) continue;
      const int next = sectionOf_[cell + stride];
      if (next == kNoSection) continue;
      addOnce(section(sectionOf_[cell]).after, next);
      addOnce(section(next).before, sectionOf_[cell]);
    }
  }

  /// The one section that follows and is followed by this one only; -1 where the way branches.
  int onlyNext(int id) {
    if (section(id).after.size() != 1) return -1;
    const int next = section(id).after.front();
    return section(next).before.size() == 1 ? next : -1;
  }

  bool isChainStart(int id) { return section(id).before.size() != 1 || onlyNext(section(id).before.front()) != id; }

  std::vector<int> chainFrom(int start) {
    std::vector<int> chain{start};
    for (int next = onlyNext(start); next >= 0; next = onlyNext(next)) chain.push_back(next);
    return chain;
  }

  double largest(const std::vector<int>& ids) {
    double area = 0.0;
    for (const int id : ids) area = std::max(area, section(id).area());
    return area;
  }

  void searchChain(const std::vector<int>& chain, std::vector<Passage>& found) {
    const double before = largest(section(chain.front()).before);
    const double after = largest(section(chain.back()).after);
    search(chain, 0, chain.size(), before, after, found);
  }

  /// Looks for the narrowest place of chain[first, last) between sections of the given sizes, then on
  /// both sides of it.
  void search(const std::vector<int>& chain, std::size_t first, std::size_t last, double before, double after,
              std::vector<Passage>& found) {
    if (first >= last) return;
    const auto area = [&](std::size_t i) { return section(chain[i]).area(); };
    std::size_t narrowest = first;
    for (std::size_t i = first; i < last; ++i) {
      if (area(i) < area(narrowest)) narrowest = i;
    }
    double left = before;
    for (std::size_t i = first; i < narrowest; ++i) left = std::max(left, area(i));
    double right = after;
    for (std::size_t i = narrowest; i < last; ++i) right = std::max(right, area(i));
    std::size_t begin = narrowest;
    while (begin > first && area(begin - 1) <= kSameSection * area(narrowest)) --begin;
    std::size_t end = narrowest + 1;
    while (end < last && area(end) <= kSameSection * area(narrowest)) ++end;
    accept(chain, begin, end, area(narrowest), std::min(left, right), found);
    if (begin > first) search(chain, first, begin, before, area(narrowest), found);
    if (end < last) search(chain, end, last, area(narrowest), after, found);
  }

  void accept(const std::vector<int>& chain, std::size_t begin, std::size_t end, double narrowest, double around,
              std::vector<Passage>& found) {
    const double contraction = around / narrowest;
    const bool doorway = contraction >= kLeastContraction && static_cast<double>(end - begin) <= std::sqrt(narrowest);
    if (narrowest < kLeastSection || !(doorway || contraction >= kTightContraction)) return;
    Passage passage{axis_, {}, contraction};
    for (std::size_t i = begin; i < end; ++i) {
      const Section& slice = section(chain[i]);
      passage.cells.insert(passage.cells.end(), cells_.begin() + static_cast<std::ptrdiff_t>(slice.firstCell),
                           cells_.begin() + static_cast<std::ptrdiff_t>(slice.endCell));
    }
    std::sort(passage.cells.begin(), passage.cells.end());
    found.push_back(std::move(passage));
  }

  static constexpr int kNoSection = -1;

  const CellGrid& grid_;
  int axis_;
  std::vector<int> sectionOf_;      ///< by cell
  std::vector<std::size_t> cells_;  ///< section by section
  std::vector<Section> sections_;
};

double sharpest(const std::vector<Passage>& passages) {
  double contraction = 0.0;
  for (const Passage& passage : passages) contraction = std::max(contraction, passage.contraction);
  return contraction;
}

}  // namespace

std::vector<Passage> findPassages(const FreeSpace& space, const StopToken& stop) {
  std::vector<char> open(space.grid.size());
  for (std::size_t cell = 0; cell < open.size(); ++cell) open[cell] = space.open(cell) ? 1 : 0;
  std::array<Slices, 3> axes{Slices(space.grid, 0), Slices(space.grid, 1), Slices(space.grid, 2)};
  std::vector<Passage> all;
  for (int round = 0; round < kMostRounds && !stop.stopRequested(); ++round) {
    std::vector<Passage> best;
    for (Slices& slices : axes) {
      auto found = slices.passages(open, stop);
      if (sharpest(found) > sharpest(best)) best = std::move(found);
    }
    if (best.empty()) break;
    for (Passage& passage : best) {
      for (const std::size_t cell : passage.cells) open[cell] = 0;
      all.push_back(std::move(passage));
    }
  }
  return all;
}

}  // namespace glissade
