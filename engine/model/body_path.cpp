#include "engine/model/body_path.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr char kSeparator = '/';

}  // namespace

std::vector<std::string> stepsOf(const std::string& path) {
  std::vector<std::string> steps;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find(kSeparator, begin), path.size());
    if (end > begin) steps.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return steps;
}

std::string firstStepOf(const std::string& path) { return path.substr(0, path.find(kSeparator)); }

std::string lastStepOf(const std::string& path) {
  const std::size_t before = path.size() < 2 ? std::string::npos : path.rfind(kSeparator, path.size() - 2);
  return before == std::string::npos ? path : path.substr(before + 1);
}

std::string pathOf(const std::vector<std::string>& steps) {
  std::string path;
  for (const std::string& step : steps) path = joinedPath(path, step);
  return path;
}

std::string withoutNumber(const std::string& step) {
  const std::size_t number = step.rfind('#');
  const bool counted = number != std::string::npos && number > 0 &&
                       step.find_first_not_of("0123456789", number + 1) == std::string::npos;
  return counted ? step.substr(0, number) : step;
}

bool isNumbered(const std::string& step, const std::string& name) {
  const std::string numbered = name + "#";
  return step.size() > numbered.size() && step.compare(0, numbered.size(), numbered) == 0 &&
         step.find_first_not_of("0123456789", numbered.size()) == std::string::npos;
}

std::string joinedPath(const std::string& path, const std::string& rest) {
  return path.empty() || rest.empty() ? path + rest : path + kSeparator + rest;
}

std::vector<std::string> assembliesAbove(const std::string& path) {
  std::vector<std::string> assemblies;
  for (std::size_t end = path.find(kSeparator); end != std::string::npos; end = path.find(kSeparator, end + 1)) {
    assemblies.push_back(path.substr(0, end));
  }
  return assemblies;
}

bool isWithin(const std::string& path, const std::string& node) {
  return node.empty() || path == node || path.compare(0, node.size() + 1, node + kSeparator) == 0;
}

std::string pathWithin(const std::string& path, const std::string& node) {
  if (node.empty()) return path;
  return path == node ? "" : path.substr(node.size() + 1);
}

bool endsInPath(const std::string& path, const std::string& end) {
  if (path == end) return true;
  const std::string tail = kSeparator + end;
  return path.size() > tail.size() && path.compare(path.size() - tail.size(), tail.size(), tail) == 0;
}

bool isMeantBy(const std::string& name, const std::string& path) {
  if (endsInPath(path, name)) return true;
  const std::vector<std::string> above = assembliesAbove(path);
  return std::any_of(above.begin(), above.end(),
                     [&](const std::string& assembly) { return endsInPath(assembly, name); });
}

}  // namespace glissade
