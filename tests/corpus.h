#pragma once

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace tractus {

// Returns the folder of recordings, descriptors, models and strokes that may not be distributed
// with the program, from the environment variable TRACTUS_CORPUS. Empty if it is not set.
inline std::filesystem::path corpus()
{
    char const* const folder = std::getenv("TRACTUS_CORPUS");
    return folder ? std::filesystem::path(folder) : std::filesystem::path();
}

// Returns the path of a file or folder in tests/data, which is distributed with the tests.
inline std::filesystem::path shipped(std::filesystem::path const& name)
{
    return std::filesystem::path(__FILE__).parent_path() / "data" / name;
}

} // namespace tractus

// Skips the running test, with a message, if there is no corpus. The test's name must be listed in
// CORPUS of its program in CMakeLists.txt, which prints one line for all skipped tests.
#define REQUIRE_CORPUS()                                                                           \
    if (::tractus::corpus().empty())                                                               \
    GTEST_SKIP() << "TRACTUS_CORPUS is not set: this test needs the folder of recordings"
