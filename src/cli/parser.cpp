// SPDX-License-Identifier: MIT
#include "cli/parser.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "convexact/error.hpp"

namespace convexact::cli {
namespace {

// No value of an option and no name of a file is empty: an empty text is a variable that a script
// did not set.
Option refusing_empty(CLI::Option* option) {
  option->check([](const std::string& text) {
    return text.empty() ? "expected a value, found an empty text" : "";
  });
  return Option(option);
}

constexpr const char* kFurther = "Further options";

// Options that few runs need are shown on request only.
class Help : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    shows_all_ = mode == CLI::AppFormatMode::All;
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    const std::size_t gap = text.find("\n\n\n");  // where a group is left out
    return gap == text.npos ? text : text.erase(gap, 1);
  }
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    if (group == kFurther && !shows_all_) return "";
    return CLI::Formatter::make_group(std::move(group), is_positional, std::move(options));
  }

 private:
  mutable bool shows_all_ = false;
};

}  // namespace

// ---- Options

Option Option::required(bool is_required) {
  option_->required(is_required);
  return *this;
}
Option Option::expected(int words) {
  option_->expected(words);
  return *this;
}
Option Option::allow_extra_args(bool takes) {
  option_->allow_extra_args(takes);
  return *this;
}
Option Option::take_all() {
  option_->take_all();
  return *this;
}
Option Option::needs(Option other) {
  option_->needs(other.option_);
  return *this;
}
Option Option::excludes(Option other) {
  option_->excludes(other.option_);
  return *this;
}
Option Option::check(const std::function<std::string(const std::string& text)>& complaint) {
  option_->check(complaint);
  return *this;
}
Option Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}
Option Option::between(long least, long most) {
  option_->check(CLI::Range(least, most));
  return *this;
}
Option Option::type_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}
Option Option::description(const std::string& meaning) {
  option_->description(meaning);
  return *this;
}
Option Option::default_str(const std::string& text) {
  option_->default_str(text);
  return *this;
}
Option Option::capture_default_str() {
  option_->capture_default_str();
  return *this;
}
std::string Option::name() const { return option_->get_name(); }
bool Option::is_given() const { return option_->count() > 0; }

// ---- Commands

Command::Command(const std::string& description, const std::string& name)
    : own_(std::make_unique<CLI::App>(description, name)), app_(own_.get()) {
  app_->formatter(std::make_shared<Help>());  // of its subcommands, too
}
Command::Command(CLI::App* app) : app_(app) {}
Command::~Command() = default;

Command* Command::add_subcommand(const std::string& name, const std::string& description) {
  CLI::App* const app = app_->add_subcommand(name, description);
  subcommands_.emplace_back(new Command(app));  // its constructor is private
  return subcommands_.back().get();
}

Option Command::add_option(const std::string& names, std::string& value,
                           const std::string& meaning) {
  return refusing_empty(app_->add_option(names, value, meaning));
}
Option Command::add_option(const std::string& names, std::optional<std::string>& value,
                           const std::string& meaning) {
  return refusing_empty(app_->add_option(names, value, meaning));
}
Option Command::add_option(const std::string& names, std::vector<std::string>& values,
                           const std::string& meaning) {
  // Words without a name may be those of a program, which takes what it likes.
  CLI::Option* const option = app_->add_option(names, values, meaning);
  return option->get_positional() ? Option(option) : refusing_empty(option);
}
Option Command::add_option(const std::string& names, long& value, const std::string& meaning) {
  return Option(app_->add_option(names, value, meaning));
}
Option Command::add_flag(const std::string& names, bool& value, const std::string& meaning) {
  return Option(app_->add_flag(names, value, meaning));
}
Option Command::add_flag_function(const std::string& names, const std::function<void()>& take,
                                  const std::string& meaning) {
  return Option(app_->add_flag_callback(names, take, meaning));
}
Option Command::add_option_function(const std::string& names,
                                    const std::function<void(const std::string& text)>& take,
                                    const std::string& meaning) {
  const std::function<void(const std::string&)> take_or_refuse = [take](const std::string& text) {
    try {
      take(text);
    } catch (const Error& error) {
      throw CLI::ValidationError(error.what());
    }
  };
  return refusing_empty(app_->add_option_function<std::string>(names, take_or_refuse, meaning));
}

Command* Command::footer(const std::string& text) {
  app_->footer(text);
  return this;
}
void Command::show_first(std::initializer_list<const char*> names) {
  const std::vector<std::string> first(names.begin(), names.end());
  std::size_t further = 0;
  for (CLI::Option* const option : app_->get_options()) {
    if (option->get_positional() || option == app_->get_help_ptr()) continue;
    if (std::find(first.begin(), first.end(), option->get_name()) != first.end()) continue;
    option->group(kFurther);
    ++further;
  }
  app_->set_help_all_flag("--help-all",
                          "show the " + std::to_string(further) + " further options, too");
}
Command* Command::group(const std::string& title) {
  app_->group(title);
  return this;
}
Command* Command::callback(const std::function<void()>& run) {
  app_->callback(run);
  return this;
}
Command* Command::when_named(const std::function<void()>& add) {
  app_->preparse_callback([add](std::size_t) { add(); });
  return this;
}
Command* Command::fallthrough() {
  app_->fallthrough();
  return this;
}
Command* Command::allow_extras() {
  app_->allow_extras();
  return this;
}
void Command::require_subcommand(int count) { app_->require_subcommand(count); }
void Command::require_subcommand(int least, int most) {
  app_->require_subcommand(static_cast<std::size_t>(least), static_cast<std::size_t>(most));
}
void Command::set_version_flag(const std::string& name, const std::string& version) {
  app_->set_version_flag(name, version);
}

Option Command::get_option(const std::string& name) { return Option(app_->get_option(name)); }
std::optional<Option> Command::find_option(const std::string& name) const {
  CLI::Option* const option = app_->get_option_no_throw(name);
  return option == nullptr ? std::nullopt : std::optional(Option(option));
}
std::vector<Option> Command::options() const {
  std::vector<Option> list;
  for (CLI::Option* const option : app_->get_options()) list.emplace_back(option);
  return list;
}
const Command* Command::parsed_subcommand() const {
  const std::vector<CLI::App*> parsed = app_->get_subcommands();
  for (const auto& command : subcommands_) {
    if (!parsed.empty() && command->app_ == parsed.front()) return command.get();
  }
  return nullptr;
}
std::string Command::name() const { return app_->get_name(); }
bool Command::is_called(const std::string& name) const { return app_->check_name(name); }
std::vector<std::string> Command::remaining() const { return app_->remaining(); }

std::optional<NotRun> Command::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      return NotRun{false, error.get_name() == "ValidationError", error.what()};
    }
    std::ostringstream text;
    app_->exit(error, text, text);
    return NotRun{true, false, text.str()};
  }
  return std::nullopt;
}

// ---- Words

std::vector<std::string> split(const std::string& text, char separator) {
  return CLI::detail::split(text, separator);
}
std::string join(const std::vector<std::string>& words, const std::string& separator) {
  return CLI::detail::join(words, separator);
}
std::string to_lower(std::string text) { return CLI::detail::to_lower(std::move(text)); }

}  // namespace convexact::cli
