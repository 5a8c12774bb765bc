#pragma once

#include <string_view>
#include <vector>

namespace tractus::lsystem {

// The lines of a text one after another, without blanks at their ends.
struct TextLines {
    std::string_view rest;
    int number = 0; // Number of the line that came last, from 1.

    // False at the text's end.
    bool next(std::string_view& line);
};

// The numbers of a line, separated by blanks. None at all where something else stands in it, or a
// number beyond 1e12.
std::vector<double> numbers_in(std::string_view line);

// Returns what follows `key` and blanks in a line that begins with it.
std::string_view after_key(std::string_view line, std::string_view key);

} // namespace tractus::lsystem
