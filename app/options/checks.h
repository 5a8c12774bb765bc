#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::options {

// Validators of option values, for CLI::Option::check(). A refused value is wrong usage; the
// message says what would be right.

// Accepts a whole number from `least` to `most`. Refuses signs and fractions.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

// Accepts any number that can be a seed.
CLI::Validator seed_number();

// Accepts a decimal number from `least` to `most`.
CLI::Validator number(double least, double most);

// Parses a range such as "0.3..1", or one number as both ends; nullopt for anything else.
std::optional<std::pair<double, double>> parse_range(std::string const& text);

// Accepts such a range, in ascending order and from `least` to `most`.
CLI::Validator number_range(double least, double most);

// Parses a part of a whole: "2/8" is the second of eight. nullopt for anything else.
std::optional<std::pair<std::size_t, std::size_t>> parse_part(std::string const& text);

// Accepts such a part N/M with 1 ≤ N ≤ M ≤ `most`.
CLI::Validator part_of(std::size_t most);

// Accepts one of these words.
CLI::Validator one_of(std::vector<std::string> const& words);

// Adds words for shell completion to `check`, which alone decides what is accepted.
CLI::Validator with_completion_words(std::vector<std::string> const& words, CLI::Validator check);

// The words for completion that the option's checks have, including those of one_of(); empty if
// there are none.
std::vector<std::string> completion_words(CLI::Option& option);

// Accepts a file name with one of these extensions, such as ".png".
CLI::Validator name_ending_in(std::vector<std::string> endings);

// Accepts a picture's file name: with the extension .png, or without any, like /dev/stdout.
CLI::Validator picture_name();

// Accepts a height scenario (calib::parse_height_scenario()).
CLI::Validator height_scenario();

} // namespace tractus::options
