#include "engine/scenario/json_text.h"

#include <algorithm>
#include <set>
#include <vector>

namespace glissade {
namespace {

constexpr int kDeepestValue = 32;
constexpr std::size_t kMostValues = 2'000'000;

struct Refusal {
  std::string reason;
};

/// Watches the parser for what JSON allows and we do not.
class Guard {
 public:
  bool operator()(int depth, nlohmann::json::parse_event_t event, const Json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > kDeepestValue) throw Refusal{"values are nested too deeply"};
    if (event != Event::object_end && event != Event::array_end && ++values_ > kMostValues) {
      throw Refusal{"there are too many values"};
    }
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second) {
      throw Refusal{"the key '" + parsed.get<std::string>() + "' is there twice in one object"};
    }
    return true;
  }

 private:
  std::size_t values_ = 0;
  std::vector<std::set<std::string>> keys_;
};

std::string lineAndColumn(const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  const std::size_t newline = end > 0 ? text.rfind('\n', end - 1) : std::string::npos;
  const std::size_t column = newline == std::string::npos ? end + 1 : end - newline;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

bool isPlain(const Json& value) { return !value.is_structured(); }

void print(const Json& value, const std::string& indent, std::string& text) {
  if (isPlain(value) || value.empty()) {
    text += value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  const bool object = value.is_object();
  const bool oneLine = !object && std::all_of(value.begin(), value.end(), isPlain);
  const std::string inner = indent + "  ";
  text += object ? "{" : "[";
  bool first = true;
  for (const auto& [key, element] : value.items()) {
    if (!first) text += oneLine ? ", " : ",";
    first = false;
    if (!oneLine) text += "\n" + inner;
    if (object) text += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
    print(element, inner, text);
  }
  if (!oneLine) text += "\n" + indent;
  text += object ? "}" : "]";
}

}  // namespace

Result<Json> parseJson(const std::string& text, const std::string& file) {
  const auto refused = [&](const std::string& place, const std::string& reason) {
    return Diagnostic{ErrorKind::MalformedInput, file, place, reason, "Mend the file there."};
  };
  Guard guard;
  try {
    return Json::parse(text, std::ref(guard));
  } catch (const Refusal& refusal) {
    return refused("", refusal.reason);
  } catch (const Json::parse_error& error) {
    return refused(lineAndColumn(text, error.byte), "this is not JSON");
  } catch (const Json::exception&) {
    return refused("", "a number is too large");
  }
}

std::string canonicalText(const Json& document) {
  std::string text;
  print(document, "", text);
  return text + "\n";
}

Json toJson(const Vector3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json toJson(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return {{"position", toJson(pose.position)}, {"orientation", Json::array({q.x(), q.y(), q.z(), q.w()})}};
}

Json toRow(const Pose& pose) {
  const Vector3& p = pose.position;
  const Quaternion& q = pose.orientation;
  return Json::array({p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()});
}

}  // namespace glissade
