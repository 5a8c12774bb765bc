#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tractus::options {

// How --help looks: one column of options, one of sentences, within 80 columns, with defaults and
// what goes with what at the end of each sentence; examples at the end of all.
class HelpFormatter final : public CLI::Formatter {
public:
    HelpFormatter();

    std::string make_option_opts(CLI::Option const* option) const override;
    std::string make_option_desc(CLI::Option const* option) const override;
    std::string make_subcommand(CLI::App const* command) const override;
    std::string make_footer(CLI::App const* command) const override;
};

// The name of an option's value, "PIXELS". CLI11 itself puts the value's type before what a check
// takes: "INT:PIXELS".
std::string shown_type(CLI::Option const& option);

// Returns what --help says of an option, on one line: its sentence, its default and what it goes
// with.
std::string option_text(CLI::Option const& option);

} // namespace tractus::options
