#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tractus::options {

// Formats --help in one column of options and one of sentences, within 80 columns. Each sentence
// ends with the default and with the options that it needs or excludes; examples come last.
class HelpFormatter final : public CLI::Formatter {
public:
    HelpFormatter();

    std::string make_option_opts(CLI::Option const* option) const override;
    std::string make_option_desc(CLI::Option const* option) const override;
    std::string make_subcommand(CLI::App const* command) const override;
    std::string make_footer(CLI::App const* command) const override;
};

// The name of an option's value, such as "PIXELS". CLI11 alone would put the value's type before
// it: "INT:PIXELS".
std::string shown_type(CLI::Option const& option);

// Returns the help of an option on one line: its sentence, its default, and the options that it
// needs or excludes.
std::string option_help(CLI::Option const& option);

} // namespace tractus::options
