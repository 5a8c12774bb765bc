#pragma once

#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Iterates over the lines of a text. Blanks at the ends of lines are removed.
struct TextLines {
    std::string_view rest;
    int number = 0; // Number of the current line, from 1.

    // Advances to the next line. Returns false at the end of the text.
    bool next(std::string_view& line);
};

// Parses the numbers of a line, which are separated by blanks. Returns an empty list if the line
// contains anything else or a number beyond 1e12.
std::vector<double> numbers_in(std::string_view line);

// Returns the rest of a line that begins with `key`, without the blanks after the key.
std::string_view after_key(std::string_view line, std::string_view key);

} // namespace tractus::lsystem
