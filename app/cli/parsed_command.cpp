#include "app/cli/parsed_command.h"

#include <CLI/CLI.hpp>

#include "engine/base/limits.h"
#include "engine/base/quantity_text.h"

namespace glissade::cli {
namespace {

/// Converts a length as people write it to metres: 0.0005, 0.5mm, 5 cm, 1in. Units: m, cm, mm, in, inch, ft; none:
/// metres. Throws CLI::ValidationError with the reason.
double metres(const std::string& text, Language language) {
  const auto length = toMetres(text, 1.0);
  if (!length) {
    throw CLI::ValidationError(toString(
        {GLISSADE_TEXT("'%1' is not a length: give metres, or a unit as in 0.5mm (m, cm, mm, in, ft)"), {text}},
        language));
  }
  if (!limits::isCoordinate(*length)) {
    throw CLI::ValidationError(toString({GLISSADE_TEXT("'%1' is beyond 1e9 m: check the unit"), {text}}, language));
  }
  return *length;
}

}  // namespace

ParsedCommand ParsedCommand::subcommand(const std::string& name, const Message& help) const {
  CLI::App* command = app_->add_subcommand(name, text(help));
  command->group(text(GLISSADE_TEXT("Subcommands")));
  return {*command, language_};
}

CLI::Option* ParsedCommand::length(const std::string& name, const std::function<void(double)>& take,
                                   const Message& help, const std::optional<NamedLength>& named) const {
  const auto takeText = [take, named, language = language_](const std::string& text) {
    take(named && text == named->word ? named->metres : metres(text, language));
  };
  return optionFor<std::string>(name, takeText, help);
}

ParsedCommand commandLine(CLI::App& app, Language language, const std::string& version) {
  ParsedCommand command(app, language);
  app.description(command.text(GLISSADE_TEXT("Glissade: certified motions for virtual assembly")));
  const auto formatter = app.get_formatter();
  formatter->label("Usage", command.text(GLISSADE_TEXT("Usage")));
  formatter->label("Positionals", command.text(GLISSADE_TEXT("Positionals")));
  formatter->label("SUBCOMMAND", command.text(GLISSADE_TEXT("SUBCOMMAND")));
  formatter->label("REQUIRED", command.text(GLISSADE_TEXT("REQUIRED")));
  app.option_defaults()->group(command.text(GLISSADE_TEXT("Options")));
  app.set_help_flag("-h,--help", command.text(GLISSADE_TEXT("Print this help message and exit")));
  app.set_version_flag("--version", version,
                       command.text(GLISSADE_TEXT("Display program version information and exit")));
  app.require_subcommand(1);
  // Options of the command line are taken behind a command, too.
  app.fallthrough();
  return command;
}

}  // namespace glissade::cli
