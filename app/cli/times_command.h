#pragma once

#include <optional>
#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct TimesOptions {
  std::string product;  ///< as of the plan
  std::string plan;
  std::string table;       ///< file of work times; empty: the defaults
  std::string writeTable;  ///< file to write the table in force to; empty: none
  std::optional<std::size_t> stations;
  Format format = Format::Text;
};

/// glissade-cli times: how long the steps of an assembly plan take a person, which of them have to follow each other,
/// and how a line divides them. Exit code 0, 2 wrong usage, 3 unreadable input.
int runTimes(const TimesOptions& options);

}  // namespace glissade::cli
