#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace tractus {

// What an option's value may be. A value that is refused is wrong usage, and the message says what
// would be right. For CLI::Option::check().

// A whole number within limits, both included. Signs and fractions are refused.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

// Any number that a seed can be.
CLI::Validator seed_number();

// A decimal number within limits, both included.
CLI::Validator number(double least, double most);

// One of these words.
CLI::Validator one_of(std::vector<std::string> words);

// A file's name that ends in one of these, such as ".png".
CLI::Validator name_ending_in(std::vector<std::string> endings);

// A picture's file name: one that ends in .png, or has no ending at all, as /dev/stdout has none.
CLI::Validator picture_name();

// A height scenario, as parse_height_scenario reads it.
CLI::Validator height_scenario();

} // namespace tractus
