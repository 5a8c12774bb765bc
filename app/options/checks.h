#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::options {

// Validators of option values, for CLI::Option::check(). A refused value counts as wrong usage; the
// message says which values are right.

// Accepts a whole number from `least` to `most`. Refuses signs and fractions.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

// Accepts a number that can be a seed.
CLI::Validator seed_number();

// Accepts a decimal number from `least` to `most`.
CLI::Validator number(double least, double most);

// Parses a range such as "0.3..1", or a single number as both ends; nullopt for any other text.
std::optional<std::pair<double, double>> parse_range(std::string const& text);

// Accepts a range as parse_range() reads it, in ascending order and within `least` to `most`.
CLI::Validator number_range(double least, double most);

// Parses a part N/M of a whole: "2/8" is the second of eight parts. nullopt for any other text.
std::optional<std::pair<std::size_t, std::size_t>> parse_part(std::string const& text);

// Accepts a part N/M as parse_part() reads it, with 1 ≤ N ≤ M ≤ `most`.
CLI::Validator part_of(std::size_t most);

// Accepts one of `words`.
CLI::Validator one_of(std::vector<std::string> const& words);

// Adds words for shell completion to `check`. The words do not change what `check` accepts.
CLI::Validator with_completion_words(std::vector<std::string> const& words, CLI::Validator check);

// Accepts any text. Shell completion offers `words`, for options that also accept others, such as
// names of files.
CLI::Validator suggest(std::vector<std::string> const& words);

// Returns the words for shell completion stored in the option's validators, including those of
// one_of(). Empty if there are none.
std::vector<std::string> completion_words(CLI::Option& option);

// Accepts a file name with one of the extensions `endings`, such as ".png".
CLI::Validator name_ending_in(std::vector<std::string> endings);

// Accepts the file name of a picture: with the extension .png, or without one, like /dev/stdout.
CLI::Validator picture_name();

// Accepts a height scenario (calib::parse_height_scenario()).
CLI::Validator height_scenario();

} // namespace tractus::options
