#include "engine/documents/plan_graph.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "engine/documents/plan_tasks.h"
#include "engine/documents/plan_words.h"
#include "engine/documents/xml_text.h"

namespace glissade {
namespace {

constexpr double kBoxWidth = 132.0;
constexpr double kBoxHeight = 28.0;
constexpr double kColumnGap = 56.0;
constexpr double kRowGap = 12.0;
constexpr double kMargin = 12.0;
constexpr std::size_t kMostLetters = 17;
constexpr std::size_t kFirstLetters = 10;
constexpr std::size_t kLastLetters = 6;

struct GraphNode {
  std::string text;
  std::size_t column = 0;
  std::size_t row = 0;
  bool isStep = true;
};
struct GraphArrow {
  std::size_t from;
  std::size_t to;
  bool blocks = false;  ///< the arrow leads to a stuck part
};

/// The direct predecessors of each step, without those that other predecessors imply; counted from 0.
std::vector<std::vector<std::size_t>> directlyBefore(const AssemblyPlan& plan) {
  std::vector<std::set<std::size_t>> all(plan.steps.size());
  std::vector<std::vector<std::size_t>> direct(plan.steps.size());
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    std::set<std::size_t> implied;
    for (const std::size_t number : plan.steps[i].after) {
      all[i].insert(number - 1);
      implied.insert(all[number - 1].begin(), all[number - 1].end());
    }
    for (const std::size_t number : plan.steps[i].after) {
      if (implied.count(number - 1) == 0) direct[i].push_back(number - 1);
    }
    all[i].insert(implied.begin(), implied.end());
  }
  return direct;
}

/// Positions of the boxes and of the arrows between them.
class GraphLayout {
 public:
  GraphLayout(const AssemblyPlan& plan, const AssembledProduct& product, const DocumentWords& words)
      : plan_(plan), product_(product), words_(words) {
    addSteps();
    addStuck();
  }

  std::vector<GraphNode> nodes;
  std::vector<GraphArrow> arrows;
  std::vector<std::size_t> rows;  ///< rows of each column

 private:
  std::size_t add(const std::string& text, std::size_t column, bool isStep) {
    if (rows.size() <= column) rows.resize(column + 1, 0);
    nodes.push_back({text, column, rows[column]++, isStep});
    return nodes.size() - 1;
  }

  void addSteps() {
    const auto before = directlyBefore(plan_);
    for (std::size_t i = 0; i < plan_.steps.size(); ++i) {
      std::size_t column = 0;
      for (const std::size_t earlier : before[i]) column = std::max(column, nodes[earlier].column + 1);
      add(stepNumber(plan_.steps.size() - 1 - i) + "  " + nameOfStep(plan_.steps[i], product_), column, true);
      for (const std::size_t earlier : before[i]) arrows.push_back({earlier, i});
    }
  }

  std::size_t nodeOf(const BodyId& id, std::size_t column) {
    const auto known = bodies_.find(id);
    if (known != bodies_.end()) return known->second;
    const auto& staying = plan_.staying;
    const bool stays = std::find(staying.begin(), staying.end(), id) != staying.end();
    const std::string name = product_.body(id).shown();
    return bodies_[id] =
               add(name + " (" + words_(stays ? GLISSADE_TEXT("base") : GLISSADE_TEXT("stuck")) + ")", column, false);
  }

  void addStuck() {
    const std::size_t column = rows.size();
    for (const StuckBody& stuck : plan_.stuck) nodeOf(stuck.body, column);
    for (const StuckBody& stuck : plan_.stuck) {
      for (const BodyId& other : stuck.blockedBy) {
        const std::size_t from = nodeOf(other, column + 1);
        arrows.push_back({from, nodeOf(stuck.body, column), true});
      }
    }
  }

  const AssemblyPlan& plan_;
  const AssembledProduct& product_;
  const DocumentWords& words_;
  std::map<BodyId, std::size_t> bodies_;
};

double left(const GraphNode& node) { return kMargin + static_cast<double>(node.column) * (kBoxWidth + kColumnGap); }
double top(const GraphNode& node) { return kMargin + static_cast<double>(node.row) * (kBoxHeight + kRowGap); }
double middle(const GraphNode& node) { return top(node) + 0.5 * kBoxHeight; }

/// The beginning and the end of a long text. UTF-8 is cut before a character.
std::string cut(const std::string& text) {
  std::vector<std::size_t> letters;  // position of the first byte of each character
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) letters.push_back(i);
  }
  if (letters.size() <= kMostLetters) return text;
  return text.substr(0, letters[kFirstLetters]) + "…" + text.substr(letters[letters.size() - kLastLetters]);
}

std::string arrowSvg(const GraphNode& from, const GraphNode& to, bool blocks, const GraphColours& colours) {
  const bool back = from.column >= to.column;
  const double x0 = back ? left(from) : left(from) + kBoxWidth;
  const double x1 = back ? left(to) + kBoxWidth : left(to);
  const double reach = back && from.column == to.column ? 0.5 * kColumnGap : 0.5 * (x1 - x0);
  const std::string& colour = blocks ? colours.stuck : colours.line;
  const double tip = back ? 7.0 : -7.0;
  const auto point = [](double x, double y) { return pixels(x) + " " + pixels(y); };
  return "<path d=\"M" + point(x0, middle(from)) + " C" + point(x0 + reach, middle(from)) + " " +
         point(x1 - reach, middle(to)) + " " + point(x1 + tip, middle(to)) + "\" fill=\"none\" stroke=\"" + colour +
         "\" stroke-width=\"1.4\"" + (blocks ? " stroke-dasharray=\"5 3\"" : "") + "/>\n<path d=\"M" +
         point(x1, middle(to)) + " L" + point(x1 + tip, middle(to) - 4.0) + " L" + point(x1 + tip, middle(to) + 4.0) +
         " Z\" fill=\"" + colour + "\"/>\n";
}

std::string boxSvg(const GraphNode& node, const GraphColours& colours) {
  return "<rect x=\"" + pixels(left(node)) + "\" y=\"" + pixels(top(node)) + "\" width=\"" + pixels(kBoxWidth) +
         "\" height=\"" + pixels(kBoxHeight) + "\" rx=\"4\" fill=\"" + colours.box + "\" stroke=\"" +
         (node.isStep ? colours.line : colours.stuck) + "\"><title>" + escaped(node.text) + "</title></rect>\n" +
         svgText(left(node) + 8.0, middle(node) + 4.0, "start", cut(node.text), colours.ink);
}

}  // namespace

std::string planGraphSvg(const AssemblyPlan& plan, const AssembledProduct& product, const DocumentWords& words,
                         const GraphColours& colours) {
  const GraphLayout layout(plan, product, words);
  const std::size_t rows =
      layout.rows.empty() ? std::size_t{1} : *std::max_element(layout.rows.begin(), layout.rows.end());
  const double columns = static_cast<double>(std::max<std::size_t>(1, layout.rows.size()));
  const double width = 2.0 * kMargin + columns * (kBoxWidth + kColumnGap) - kColumnGap;
  const double height = 2.0 * kMargin + static_cast<double>(rows) * (kBoxHeight + kRowGap) - kRowGap;
  std::string svg = svgBegin(width, height, colours.ground);
  for (const GraphArrow& arrow : layout.arrows) {
    svg += arrowSvg(layout.nodes[arrow.from], layout.nodes[arrow.to], arrow.blocks, colours);
  }
  for (const GraphNode& node : layout.nodes) svg += boxSvg(node, colours);
  return svg + "</svg>\n";
}

}  // namespace glissade
