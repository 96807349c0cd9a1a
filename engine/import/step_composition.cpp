#include "engine/import/step_composition.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "engine/base/file.h"
#include "engine/import/import_limits.h"
#include "engine/import/import_protocol.h"
#include "engine/import/step_part_file.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

constexpr CatalogueText kUnread = GLISSADE_TEXT("Export the part as a solid with faces, or as triangles.");
constexpr CatalogueText kAdvice =
    GLISSADE_TEXT("Put the files there and load again, or export the product as one file.");

/// "'a', 'b' and 3 more".
Message listed(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i > 0 ? ", '" : "'") + names[i] + "'";
  if (names.size() <= most) return Message(text);
  return {GLISSADE_TEXT("%1 and %2 more"), {text, names.size() - most}};
}

class Composition {
 public:
  Composition(const FileContent& content, const StepFileReader& read)
      : content_(content), read_(read), folder_(folderOf(content.file)), bytes_(content.bytes.size()) {}

  Result<StepProduct> run() {
    auto answer = read_(content_);
    if (!answer) return answer.error();
    const File top{content_.file, "", std::move(*answer)};
    countTriangles(top.answer);
    product_.warnings = top.answer.warnings;
    takeMissing(top.file, top.answer.missing);
    if (const Outcome added = add(top, {top.answer.rootName, Pose::identity(), 0}); !added) return added.error();
    if (product_.parts.empty()) return nothingLeft();
    warnOfMissing();
    return std::move(product_);
  }

 private:
  struct File {
    std::string file;
    std::string folder;  ///< relative to the product's folder
    StepAnswer answer;
  };
  /// The place of a file's product.
  struct Place {
    std::string path;
    Pose X_FP;
    int depth = 0;
    std::vector<NodeNames> names{};  ///< see Occurrence::names
  };
  struct Missing {
    std::string name;
    Message whyNot;
    std::vector<std::string> paths;  ///< paths of its parts
  };

  /// Occurrence::names for a path below the place.
  static std::vector<NodeNames> joinedNames(const Place& place, const std::string& path,
                                            const std::vector<NodeNames>& names) {
    if (place.names.empty() && names.empty()) return {};
    std::vector<NodeNames> all = place.names.empty() ? productNames(stepsOf(place.path)) : place.names;
    const std::vector<NodeNames> below = names.empty() ? productNames(stepsOf(path)) : names;
    all.insert(all.end(), below.begin(), below.end());
    return all;
  }

  Outcome add(const File& file, const Place& place) {
    chain_.push_back(&file);
    for (const Occurrence& part : file.answer.parts) {
      if (product_.parts.size() == protocol::kMostParts) {
        return refusal(content_.file, {GLISSADE_TEXT("has more than %1 parts"), {protocol::kMostParts}});
      }
      product_.parts.push_back(part);
      product_.parts.back().path = joinedPath(place.path, part.path);
      product_.parts.back().names = joinedNames(place, part.path, part.names);
      if (!part.formerPath.empty()) product_.parts.back().formerPath = joinedPath(place.path, part.formerPath);
      if (place.depth > 0) product_.parts.back().X_FP = place.X_FP * part.X_FP;
    }
    for (const StepExternal& external : file.answer.externals) {
      if (const Outcome added = addExternal(file, external, place); !added) return added;
    }
    chain_.pop_back();
    return Done{};
  }

  Outcome addExternal(const File& in, const StepExternal& external, const Place& place) {
    if (++occurrences_ > protocol::kMostOccurrences) {
      return refusal(content_.file,
                     {GLISSADE_TEXT("places other files more than %1 times, those that they place counted"),
                      {protocol::kMostOccurrences}});
    }
    if (place.depth == protocol::kDeepestAssembly) {
      return refusal(in.file, GLISSADE_TEXT("is nested too deeply in other files"));
    }
    const std::string path = joinedPath(place.path, external.path);
    const FoundStepPart found = findStepPart(folder_, in.folder, external.file);
    if (found.file.empty()) {
      noteMissing(found, path);
      return Done{};
    }
    const auto file = fileOf(found);
    if (!file) return file.error();
    if (std::find(chain_.begin(), chain_.end(), *file) != chain_.end()) {
      return refusal(in.file, {GLISSADE_TEXT("names '%1' for a part, which holds this file itself"), {found.name}});
    }
    return add(**file,
               {path, place.X_FP * external.X_FP, place.depth + 1, joinedNames(place, external.path, external.names)});
  }

  /// The file, which is read at first use.
  Result<const File*> fileOf(const FoundStepPart& found) {
    std::unique_ptr<File>& known = files_[found.name];
    if (known) return known.get();
    if (files_.size() > protocol::kMostFiles) {
      return refusal(content_.file, {GLISSADE_TEXT("names more than %1 files"), {protocol::kMostFiles}});
    }
    const auto content = readContent(found.file, protocol::kStepLimits.bytes);
    if (!content) return content.error();
    bytes_ += content->bytes.size();
    if (bytes_ > mostFileBytes()) {
      return refusal(content_.file,
                     {GLISSADE_TEXT("and the files that it names have more than %1"), {sizeInWords(mostFileBytes())}});
    }
    auto answer = read_(*content);
    if (!answer) return answer.error();
    if (!countTriangles(*answer)) {
      return refusal(content_.file, {GLISSADE_TEXT("needs more than %1 triangles"), {protocol::kMostElements}});
    }
    product_.warnings.insert(product_.warnings.end(), answer->warnings.begin(), answer->warnings.end());
    takeMissing(found.file, answer->missing);
    product_.partFiles.push_back({found.name, sha256(content->bytes)});
    const std::string folder = folderOf(found.name);
    known = std::make_unique<File>(File{found.file, folder == "." ? "" : folder, std::move(*answer)});
    return known.get();
  }

  /// True if all files together are within the limit of triangles.
  bool countTriangles(const StepAnswer& answer) {
    std::set<const TriangleMesh*> counted;
    for (const Occurrence& part : answer.parts) {
      if (counted.insert(part.mesh.get()).second) triangles_ += part.mesh->triangles.size();
    }
    return triangles_ <= protocol::kMostElements;
  }

  void takeMissing(const std::string& file, const MissingShapes& shapes) {
    constexpr std::size_t kMost = 100;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      MissingShape shape = shapes[i];
      shape.file = file;
      if (i < kMost) product_.warnings.push_back(warningOf(shape));
      product_.missing.push_back(std::move(shape));
    }
    if (shapes.size() <= kMost) return;
    product_.warnings.push_back({ErrorKind::MalformedInput,
                                 file,
                                 "",
                                 {GLISSADE_TEXT("%1 more of its shapes are missing"), {shapes.size() - kMost}},
                                 kUnread});
  }

  static Diagnostic warningOf(const MissingShape& shape) {
    const std::string what = shape.kind.empty() ? shape.entity : shape.kind + " " + shape.entity;
    return {ErrorKind::MalformedInput,
            shape.file,
            shape.product.empty() ? Message() : Message(GLISSADE_TEXT("part '%1'"), {shape.product}),
            {GLISSADE_TEXT("nothing is known of where %1 is, and certificates are about the product without it: %2"),
             {what, shape.reason}},
            kUnread};
  }

  void noteMissing(const FoundStepPart& found, const std::string& path) {
    const auto [missing, isNew] = missing_.try_emplace(found.name);
    missing->second.paths.push_back(path);
    if (!isNew) return;
    missing->second.name = found.name;
    missing->second.whyNot = found.whyNot;
    missingInOrder_.push_back(found.name);
    product_.partFiles.push_back({found.name, ""});
    product_.missing.push_back({content_.file, path, "'" + found.name + "'", "file", found.whyNot});
  }

  void warnOfMissing() {
    constexpr std::size_t kMost = 20;
    for (std::size_t i = 0; i < std::min(kMost, missingInOrder_.size()); ++i) {
      product_.warnings.push_back(warningOf(missing_.at(missingInOrder_[i])));
    }
    if (missingInOrder_.size() <= kMost) return;
    product_.warnings.push_back({ErrorKind::MalformedInput,
                                 content_.file,
                                 "",
                                 {GLISSADE_TEXT("%1 more {1|file of its parts is|files of its parts are} missing"),
                                  {missingInOrder_.size() - kMost}},
                                 kAdvice});
  }

  Diagnostic warningOf(const Missing& missing) const {
    return {ErrorKind::MalformedInput,
            content_.file,
            {GLISSADE_TEXT("part %1"), {listed(missing.paths, 3)}},
            {GLISSADE_TEXT("is missing, and certificates take it as free space: its file '%1' %2 (looked for in '%3')"),
             {missing.name, missing.whyNot, folder_}},
            kAdvice};
  }

  Diagnostic nothingLeft() const {
    return {ErrorKind::MalformedInput,
            content_.file,
            "",
            {GLISSADE_TEXT("has its parts in other files, and none of them is there: %1 (looked for in '%2')"),
             {listed(missingInOrder_, 10), folder_}},
            kAdvice};
  }

  static Diagnostic refusal(const std::string& file, const Message& reason) {
    return {ErrorKind::MalformedInput, file, "", reason, GLISSADE_TEXT("Export the product as one file.")};
  }

  const FileContent& content_;
  const StepFileReader& read_;
  std::string folder_;
  std::uint64_t bytes_;
  std::uint64_t triangles_ = 0;
  std::size_t occurrences_ = 0;
  StepProduct product_;
  std::vector<const File*> chain_;  ///< files that are being added, each one named by the one before
  std::map<std::string, std::unique_ptr<File>> files_;
  std::map<std::string, Missing> missing_;
  std::vector<std::string> missingInOrder_;
};

}  // namespace

Result<StepProduct> composeStepProduct(const FileContent& content, const StepFileReader& read) {
  return Composition(content, read).run();
}

}  // namespace glissade
