// SPDX-License-Identifier: MIT
// parser.hpp - commands and their options.
//
// The parser is CLI11, behind functions that are no templates: its header takes seconds to compile,
// so that one source includes it, and all that declare options include this.
#pragma once
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace convexact::cli {

/// An option of a command, while the command exists. Each function returns the option again, for
/// chains such as `command.add_option(...)->required()`.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option* operator->() { return this; }

  Option required(bool is_required = true);
  Option expected(int words);           ///< How many words follow; -1: one or more.
  Option allow_extra_args(bool takes);  ///< Whether more words than expected are its own, too.
  Option take_all();                    ///< Given more than once, it keeps everything.
  Option needs(Option other);
  Option excludes(Option other);
  /// @param complaint  Empty if the text is right.
  Option check(const std::function<std::string(const std::string& text)>& complaint);
  Option one_of(const std::vector<std::string>& words);
  Option between(long least, long most);
  Option type_name(const std::string& name);
  Option description(const std::string& meaning);
  Option default_str(const std::string& text);
  Option capture_default_str();  ///< The help shows the present value.

  std::string name() const;
  bool is_given() const;

 private:
  CLI::Option* option_;
};

/// Why a command line was not run.
struct NotRun {
  bool is_answer = false;    ///< Help or version, as asked for; otherwise wrong usage.
  bool is_of_value = false;  ///< Wrong usage that names the option and its value.
  std::string text;
};

/// A program, or one of its subcommands.
class Command {
 public:
  Command(const std::string& description, const std::string& name);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  /// Owned by this command.
  Command* add_subcommand(const std::string& name, const std::string& description);

  Option add_option(const std::string& names, std::string& value, const std::string& meaning);
  Option add_option(const std::string& names, std::optional<std::string>& value,
                    const std::string& meaning);
  Option add_option(const std::string& names, std::vector<std::string>& values,
                    const std::string& meaning);
  Option add_option(const std::string& names, long& value, const std::string& meaning);
  Option add_flag(const std::string& names, bool& value, const std::string& meaning);
  Option add_flag_function(const std::string& names, const std::function<void()>& take,
                           const std::string& meaning);
  /// An option whose text goes to `take`. An Error that it throws is wrong usage.
  Option add_option_function(const std::string& names,
                             const std::function<void(const std::string& text)>& take,
                             const std::string& meaning);

  Command* footer(const std::string& text);
  /// Call it when all options are there: --help shows these, --help-all shows the others, too.
  /// @param names  As "--faces".
  void show_first(std::initializer_list<const char*> names);
  Command* group(const std::string& title);  ///< Its heading in the help of its parent.
  Command* callback(const std::function<void()>& run);
  /// Calls `add` when the command line names this command, before what follows is read: what it
  /// adds is not made for every other run.
  Command* when_named(const std::function<void()>& add);
  Command* fallthrough();   ///< Options of the parent may follow, too.
  Command* allow_extras();  ///< Words that nothing takes are kept, see remaining().
  void require_subcommand(int count);
  void require_subcommand(int least, int most);
  void set_version_flag(const std::string& name, const std::string& version);

  Option get_option(const std::string& name);  ///< It exists.
  std::optional<Option> find_option(const std::string& name) const;
  std::vector<Option> options() const;
  const std::vector<std::unique_ptr<Command>>& subcommands() const { return subcommands_; }
  const Command* parsed_subcommand() const;  ///< nullptr if the command line names none.
  std::string name() const;
  bool is_called(const std::string& name) const;
  std::vector<std::string> remaining() const;

  /// Parses the command line and calls back the commands that it names.
  /// @returns Why not, if it did not.
  std::optional<NotRun> parse(int argc, char** argv);

 private:
  explicit Command(CLI::App* app);

  std::unique_ptr<CLI::App> own_;  // of the program; subcommands belong to their parents
  CLI::App* app_;
  std::vector<std::unique_ptr<Command>> subcommands_;
};

/// The parts of a text between separators; an empty one behind the last is none.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);
/// The words with separators between them.
[[nodiscard]] std::string join(const std::vector<std::string>& words, const std::string& separator);
[[nodiscard]] std::string to_lower(std::string text);

}  // namespace convexact::cli
