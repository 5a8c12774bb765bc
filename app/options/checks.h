#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::options {

// Checks of options' values. A value that is refused is wrong usage, and the message says what
// would be right. For CLI::Option::check().

// A whole number within limits, both included. Signs and fractions are refused.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

// Takes any number that a seed can be.
CLI::Validator seed_number();

// A decimal number within limits, both included.
CLI::Validator number(double least, double most);

// A range of numbers as "0.3..1", or one number for both ends; no value for anything else.
std::optional<std::pair<double, double>> parse_range(std::string const& text);

// Takes such a range within limits, both included, its lower end first.
CLI::Validator number_range(double least, double most);

// A part of a whole as "2/8", the second of eight; no value for anything else.
std::optional<std::pair<std::size_t, std::size_t>> parse_part(std::string const& text);

// Takes such a part: of at most `most`, and at least 1 and at most the whole.
CLI::Validator part_of(std::size_t most);

// Takes one of these words.
CLI::Validator one_of(std::vector<std::string> const& words);

// Does as `check`; these words are offered where the option is typed.
CLI::Validator offering(std::vector<std::string> const& words, CLI::Validator check);

// The words that the option's checks offer, those of one_of() among them; none if any value may do.
std::vector<std::string> words_offered_by(CLI::Option& option);

// A file's name that ends in one of these, such as ".png".
CLI::Validator name_ending_in(std::vector<std::string> endings);

// A picture's file name: one that ends in .png, or has no ending at all, as /dev/stdout has none.
CLI::Validator picture_name();

// A height scenario, as parse_height_scenario reads it.
CLI::Validator height_scenario();

} // namespace tractus::options
