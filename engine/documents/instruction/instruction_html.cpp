#include "engine/documents/instruction/instruction_html.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/base/file.h"
#include "engine/base/json_reader.h"
#include "engine/documents/instruction/instruction_script.h"
#include "engine/documents/report_html.h"
#include "engine/documents/xml_text.h"

namespace glissade {
namespace {

/// Content security policy of a page: it loads and runs only its own content.
constexpr const char* kPolicy =
    "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
    "connect-src data: blob:";

std::string image(const std::string& type, const std::string& bytes, const std::string& text) {
  return "<img alt=\"" + escaped(text) + "\" src=\"data:" + type + ";base64," + base64(bytes) + "\">";
}

std::string paragraph(const char* style, const std::string& text) {
  return text.empty() ? std::string() : "<p class=\"" + std::string(style) + "\">" + escaped(text) + "</p>\n";
}

/// The text with closing script tags escaped, which would end the script within a page.
std::string inScript(std::string text) {
  constexpr const char* kEnd = "</script";
  for (std::size_t at = text.find(kEnd); at != std::string::npos; at = text.find(kEnd, at)) text.insert(at + 1, "\\");
  return text;
}

class Page {
 public:
  Page(const WorkInstruction& instruction, const InstructionTemplate& look, const InstructionPictures& pictures)
      : instruction_(instruction), look_(look), pictures_(pictures), words_(instruction.language) {}

  std::string sections() {
    addCover();
    addParts();
    for (std::size_t i = 0; i < instruction_.panels.size(); ++i) addPanel(i);
    return std::move(out_);
  }

  /// Data for the script of the 3D view: the step by which each body comes, or 0 if it is there from the beginning, and
  /// the directions of viewpoints, y up. For steps within a subassembly, by the numbers of their panels: the present
  /// bodies, and the motions of the bodies that come, from the assembled world.
  std::string sceneData() const {
    nlohmann::json data{
        {"steps", nlohmann::json::array()}, {"views", nlohmann::json::array()}, {"lines", nlohmann::json::object()}};
    std::map<BodyId, std::size_t> stepOf;
    std::size_t step = 0;
    for (std::size_t i = 0; i < instruction_.panels.size(); ++i) {
      const InstructionPanel& panel = instruction_.panels[i];
      if (isInSubassembly(panel)) data["lines"][std::to_string(i)] = lineData(panel);
      for (const AssemblyStep& each : panel.steps) {
        if (!panel.subassembly.empty()) continue;
        ++step;
        for (const BodyId& id : each.bodies()) stepOf[id] = step;
      }
      const Vector3 eye = panel.view.toEye();
      data["views"].push_back({eye.x(), eye.z(), -eye.y()});
    }
    for (const BodyId& id : instruction_.bodies) data["steps"].push_back(stepOf.count(id) ? stepOf[id] : 0);
    return inScript(jsonText(data));
  }

 private:
  std::string say(CatalogueText text, std::initializer_list<MessageArgument> arguments = {}) const {
    return words_(text, arguments);
  }

  static bool isInSubassembly(const InstructionPanel& panel) {
    return !panel.subassembly.empty() && !panel.steps.empty();
  }

  nlohmann::json numbersOf(const std::vector<BodyId>& ids) const {
    nlohmann::json numbers = nlohmann::json::array();
    for (const BodyId& id : ids) {
      numbers.push_back(std::find(instruction_.bodies.begin(), instruction_.bodies.end(), id) -
                        instruction_.bodies.begin());
    }
    return numbers;
  }

  nlohmann::json lineData(const InstructionPanel& panel) const {
    nlohmann::json line{{"present", numbersOf(panel.present)}, {"moves", nlohmann::json::array()}};
    for (const AssemblyStep& step : panel.steps) {
      for (const StepMotion* motion : motionsOf(step, PlanOrder::Assembly)) {
        line["moves"].push_back({{"bodies", numbersOf(motion->bodies())}, {"poses", posesOf(*motion)}});
      }
    }
    return line;
  }

  static nlohmann::json posesOf(const StepMotion& motion) {
    nlohmann::json poses = nlohmann::json::array();
    const Pose X_AW = inverse(motion.path.front().q);
    for (auto point = motion.path.rbegin(); point != motion.path.rend(); ++point) {
      const Pose X = point->q * X_AW;
      poses.push_back({X.position.x(), X.position.y(), X.position.z(), X.orientation.x(), X.orientation.y(),
                       X.orientation.z(), X.orientation.w()});
    }
    return poses;
  }

  std::string partImage(const std::vector<BodyId>& bodies, const std::string& text) const {
    const auto found = pictures_.parts.find(bodies);
    return found == pictures_.parts.end() ? std::string() : image("image/png", found->second, text);
  }

  void addCover() {
    std::string tools;
    for (const std::string& tool : instruction_.tools) tools += (tools.empty() ? "" : " · ") + tool;
    std::string statements;
    for (const std::string& statement : instruction_.statements) statements += paragraph("", statement);
    out_ += "<section>\n<div class=\"top\"><div class=\"words\">\n" + paragraph("work", instruction_.title) +
            (instruction_.imprint.empty() ? std::string() : paragraph("soft", instruction_.imprint)) +
            paragraph("", extentText(instruction_, words_)) +
            (tools.empty() ? std::string() : paragraph("", say(GLISSADE_TEXT("Tools: %1"), {tools}))) +
            (instruction_.incomplete.empty() ? std::string() : paragraph("work", instruction_.incomplete)) +
            statements + "</div></div>\n" + "<div class=\"picture\">" +
            image("image/png", pictures_.finished, instruction_.title) + "</div>\n</section>\n";
  }

  std::string cell(PartsColumn column, const PartsListRow& row) const {
    switch (column) {
      case PartsColumn::Picture: return "<td>" + partImage({row.bodies.front()}, row.name) + "</td>";
      case PartsColumn::Part: return "<td>" + escaped(row.name) + "</td>";
      case PartsColumn::Designation: return "<td>" + escaped(row.designation) + "</td>";
      case PartsColumn::Count: return "<td class=\"count\">" + std::to_string(row.count) + "×</td>";
      case PartsColumn::Steps: break;
    }
    return "<td>" + escaped(stepsText(row, words_)) + "</td>";
  }

  void addParts() {
    out_ += "<section>\n" + paragraph("work", say(GLISSADE_TEXT("Parts list"))) + "<table><thead><tr>";
    for (const PartsColumn column : look_.columns) out_ += "<th>" + escaped(titleOf(column, words_)) + "</th>";
    out_ += "</tr></thead><tbody>\n";
    for (const PartsListRow& row : instruction_.parts) {
      out_ += "<tr>";
      for (const PartsColumn column : look_.columns) out_ += cell(column, row);
      out_ += "</tr>\n";
    }
    out_ += "</tbody></table>\n</section>\n";
  }

  void addPanel(std::size_t index) {
    const InstructionPanel& panel = instruction_.panels[index];
    out_ += "<section";
    if (panel.subassembly.empty() && !panel.steps.empty()) {
      out_ += " data-from=\"" + std::to_string(done_ + 1) + "\" data-to=\"" +
              std::to_string(done_ + panel.steps.size()) + "\" data-view=\"" + std::to_string(index) + "\"";
      done_ += panel.steps.size();
    } else if (isInSubassembly(panel)) {
      out_ += " data-line=\"" + std::to_string(index) + "\" data-view=\"" + std::to_string(index) + "\"";
    }
    out_ += ">\n<div class=\"top\"><div class=\"number\">" +
            escaped(panel.number.empty() ? say(GLISSADE_TEXT("Start")) : panel.number) +
            "</div>\n<div class=\"words\">\n" + paragraph("turn", panel.turn) + paragraph("work", panel.work) +
            paragraph("", panel.tool);
    for (const std::string& note : panel.notes) out_ += paragraph("", note);
    if (!panel.subassembly.empty()) {
      out_ += paragraph("soft", say(GLISSADE_TEXT("Subassembly for step %1"), {panel.subassembly}));
    }
    out_ += "</div>\n<div class=\"fetch\">\n";
    for (const FetchedPart& part : panel.fetched) {
      out_ += "<div>" + partImage(part.bodies, part.name) + "<strong>" + std::to_string(part.count) + "×</strong> " +
              escaped(part.name) + "</div>\n";
    }
    out_ += "</div></div>\n<div class=\"picture\">" + image("image/png", pictures_.panels[index], panel.work) +
            "</div>\n</section>\n";
  }

  const WorkInstruction& instruction_;
  const InstructionTemplate& look_;
  const InstructionPictures& pictures_;
  DocumentWords words_;
  std::string out_;
  std::size_t done_ = 0;  ///< number of steps of the product so far
};

}  // namespace

Result<std::string> instructionHtml(const WorkInstruction& instruction, const InstructionTemplate& look,
                                    const InstructionPictures& pictures, const InstructionScene* scene) {
  const DocumentWords words(instruction.language);
  std::string head = "<strong>" + escaped(instruction.title) + "</strong>";
  if (!look.company.empty()) head += "<span class=\"soft\">" + escaped(look.company) + "</span>";
  if (!look.document.empty()) head += "<span class=\"soft\">" + escaped(look.document) + "</span>";
  if (!look.logo.empty()) {
    const auto logo = readFile(look.logo, kMostLogoBytes);
    if (!logo) return logo.error();
    head += image(pictureType(*logo), *logo, look.company);
  }
  Page page(instruction, look, pictures);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"" + std::string(code(instruction.language)) +
      "\">\n<head>\n<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"" + kPolicy +
      "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(instruction.title) + "</title>\n<style>" + kInstructionStyle + "</style>\n</head>\n<body>\n<header>" +
      head + "<span id=\"place\"></span></header>\n<main>\n" + page.sections() +
      "</main>\n<nav><button id=\"previous\">◀ " + escaped(words(GLISSADE_TEXT("Previous"))) + "</button>";
  if (scene != nullptr) html += "<button id=\"scene\" class=\"scene\">3D</button>";
  html += "<button id=\"next\">" + escaped(words(GLISSADE_TEXT("Next"))) + " ▶</button></nav>\n<script>" +
          kInstructionScript + "</script>\n";
  if (scene != nullptr) {
    html += "<script type=\"application/octet-stream\" id=\"glb\">" + base64(scene->glb) + "</script>\n<script>" +
            inScript(scene->library) + "</script>\n<script>window.instructionScene = " + page.sceneData() +
            ";</script>\n<script>" + kInstructionSceneScript + "</script>\n";
  }
  return html + "</body>\n</html>\n";
}

}  // namespace glissade
