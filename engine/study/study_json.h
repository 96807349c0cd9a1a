#pragma once

#include "engine/base/json_formats.h"
#include "engine/study/study.h"

// Values in the files of this folder as JSON. Private to it. Reading throws JsonError.

namespace glissade {

extern template struct ObjectFormat<PaperColumn>;
extern template struct ObjectFormat<Finding>;

namespace study_json {

using Json = JsonCursor::Json;

/// Most rows, findings, and scenarios of a row, because names are searched sequentially.
inline constexpr std::size_t kMostRows = 1000;

/// A number for JSON; whole numbers have no decimal point.
Json number(double value);

/// Parameters by their keys.
struct ParameterNumbersFormat {
  std::map<ParameterId, double> read(const JsonCursor& at) const;
  Json write(const std::map<ParameterId, double>& values) const;
  Json schema(SchemaDefinitions& definitions) const;
};

/// Printed values by the keys of their columns. A value that is null is absent.
struct PaperFormat {
  std::map<std::string, PaperValue> read(const JsonCursor& at) const;
  Json write(const std::map<std::string, PaperValue>& values) const;
  Json schema(SchemaDefinitions& definitions) const;
};

/// Fails unless the name is one of `known`; `what` describes it in the message.
void expectOneOf(const std::string& name, const std::vector<std::string>& known, CatalogueText what,
                 const JsonCursor& at);

}  // namespace study_json

template <class Archive>
void describe(Archive& heading, Type<StudyHeading> /*type*/) {
  heading.type("heading");
  heading.required("name", &StudyHeading::name, kNonEmptyText);
  heading.required("title", &StudyHeading::title, kNonEmptyText);
  heading.optional("description", &StudyHeading::description, kText, "", Always());
  heading.optional("citation", &StudyHeading::citation, kText, "", Always());
  heading.optional("paper", &StudyHeading::paper, listOf(kObject<PaperColumn>, 0, study_json::kMostRows),
                   "Columns of the paper's table.", Always());
  heading.optional("findings", &StudyHeading::findings, listOf(kObject<Finding>, 0, study_json::kMostRows),
                   "Claims that the report proves or refutes.", Always());
}

}  // namespace glissade
