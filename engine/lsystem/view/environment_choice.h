#pragma once

#include "engine/base/result.h"

#include <map>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Names the built-in environment that answers a model's ?E modules (environments.h), and its
// numbers.
struct EnvironmentChoice {
    std::string name; // Empty for none.
    std::map<std::string, double, std::less<>> values;

    // The number of this name.
    double operator[](std::string_view key) const { return values.find(key)->second; }
};

// Whether `text` begins with the name of an environment that we have.
bool names_environment(std::string_view text);

// Reads NAME or NAME:KEY=NUMBER,KEY=NUMBER,…; blanks may stand for colon and commas. Numbers that
// are not named have their defaults. Fails, as the user's fault, for names that there are not and
// numbers out of range.
Result<EnvironmentChoice> parse_environment(std::string_view text);

} // namespace tractus::lsystem
