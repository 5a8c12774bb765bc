#pragma once

#include "engine/base/result.h"

#include <map>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// A built-in environment, which answers a model's ?E modules (environments.h), with its parameters.
struct EnvironmentChoice {
    std::string name; // Name of the environment; empty if none is chosen.
    std::map<std::string, double, std::less<>> values;

    // Returns the value of the parameter `key`, which must exist.
    double operator[](std::string_view key) const { return values.find(key)->second; }
};

// Returns true if `text` begins with the name of a built-in environment.
bool names_environment(std::string_view text);

// Parses NAME or NAME:KEY=NUMBER,KEY=NUMBER,...; blanks may replace the colon and the commas.
// Parameters that are not given have their default values. Fails with a user error for unknown
// names and for numbers out of range.
Result<EnvironmentChoice> parse_environment(std::string_view text);

} // namespace tractus::lsystem
