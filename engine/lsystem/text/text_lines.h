#pragma once

#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Iterates over the lines of a text, with trailing blanks removed.
struct TextLines {
    std::string_view rest;
    int number = 0; // Number of the current line, from 1.

    // Advances to the next line; false at the end of the text.
    bool next(std::string_view& line);
};

// Parses the numbers of a line, separated by blanks. Empty if the line contains anything else or a
// number beyond 1e12.
std::vector<double> numbers_in(std::string_view line);

// Returns the text after `key` and the blanks that follow it, in a line that begins with `key`.
std::string_view after_key(std::string_view line, std::string_view key);

} // namespace tractus::lsystem
