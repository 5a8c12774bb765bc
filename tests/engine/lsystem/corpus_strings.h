#pragma once

#include "tests/file_bytes.h"

#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace tractus::lsystem {

inline nlohmann::json read_json(std::filesystem::path const& path)
{
    return nlohmann::json::parse(file_bytes(path));
}

inline std::string without_blanks(std::string text)
{
    std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
    return text;
}

// Compares two strings of modules. Numbers in parentheses may differ by 1e-5 of their value.
inline ::testing::AssertionResult same_strings(std::string const& found,
                                               std::string const& expected)
{
    std::size_t i = 0;
    std::size_t k = 0;
    bool in_parentheses = false;
    while (i < found.size() && k < expected.size()) {
        bool const is_number = in_parentheses && found[i] != ',' && found[i] != ')';
        if (is_number) {
            std::size_t found_length = 0;
            std::size_t expected_length = 0;
            double const a = std::stod(found.substr(i, 40), &found_length);
            double const b = std::stod(expected.substr(k, 40), &expected_length);
            if (std::fabs(a - b) > 1e-5 * std::fabs(b))
                return ::testing::AssertionFailure()
                    << "at " << i << ": " << a << ", expected " << b;
            i += found_length;
            k += expected_length;
            continue;
        }
        if (found[i] != expected[k])
            return ::testing::AssertionFailure() << "at " << i << ": ..." << found.substr(i, 60)
                                                 << "\nexpected ..." << expected.substr(k, 60);
        in_parentheses = found[i] == '(' || (in_parentheses && found[i] != ')');
        ++i;
        ++k;
    }
    if (i != found.size() || k != expected.size())
        return ::testing::AssertionFailure()
            << "lengths " << found.size() << " and " << expected.size();
    return ::testing::AssertionSuccess();
}

} // namespace tractus::lsystem
