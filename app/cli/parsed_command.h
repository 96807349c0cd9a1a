#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <optional>
#include <string>

#include "engine/base/message.h"

namespace glissade::cli {

/// A command of the command line. Its help is in a language.
class ParsedCommand {
 public:
  ParsedCommand(CLI::App& app, Language language) : app_(&app), language_(language) {}

  CLI::App& app() const { return *app_; }
  std::string text(const Message& message) const { return toString(message, language_); }

  ParsedCommand subcommand(const std::string& name, const Message& help) const;

  template <class T>
  CLI::Option* option(const std::string& name, T& value, const Message& help) const {
    return app_->add_option(name, value, text(help));
  }
  template <class T>
  CLI::Option* optionFor(const std::string& name, const std::function<void(const T&)>& take,
                         const Message& help) const {
    return app_->add_option_function<T>(name, take, text(help));
  }
  /// A word that stands for a length, metres.
  struct NamedLength {
    std::string word;
    double metres = 0.0;
  };
  /// An option with a length as people write it, which `take` receives in metres; or with the named one.
  CLI::Option* length(const std::string& name, const std::function<void(double)>& take, const Message& help,
                      const std::optional<NamedLength>& named = {}) const;
  CLI::Option* flag(const std::string& name, bool& value, const Message& help) const {
    return app_->add_flag(name, value, text(help));
  }

 private:
  CLI::App* app_;
  Language language_;
};

/// The command line itself: its help, its version and the words of the help are in the language.
ParsedCommand commandLine(CLI::App& app, Language language, const std::string& version);

}  // namespace glissade::cli
