#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tractus::options {

// Formats --help within 80 columns, with options in the left column and sentences that explain them
// in the right one. Each sentence ends with the default and with the options that it needs or
// excludes. Examples come last.
class HelpFormatter final : public CLI::Formatter {
public:
    HelpFormatter();

    std::string make_option_opts(CLI::Option const* option) const override;
    std::string make_option_desc(CLI::Option const* option) const override;
    std::string make_subcommand(CLI::App const* command) const override;
    std::string make_footer(CLI::App const* command) const override;
};

// Returns the name of an option's value, such as "PIXELS". CLI11 itself would show the value's type
// before the name: "INT:PIXELS".
std::string shown_type(CLI::Option const& option);

// Returns the help of an option as one line: its sentence, its default, and the options that it
// needs or excludes.
std::string option_help(CLI::Option const& option);

} // namespace tractus::options
