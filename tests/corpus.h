#pragma once

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace tractus {

// The folder of recordings, descriptors, models and strokes that are not ours to ship, from the
// environment variable TRACTUS_CORPUS. Empty where it is not set.
inline std::filesystem::path corpus()
{
    char const* const folder = std::getenv("TRACTUS_CORPUS");
    return folder ? std::filesystem::path(folder) : std::filesystem::path();
}

// Path of a file or folder of the data that come with the tests, tests/data.
inline std::filesystem::path shipped(std::filesystem::path const& name)
{
    return std::filesystem::path(__FILE__).parent_path() / "data" / name;
}

} // namespace tractus

// Skips the running test, visibly, where there is no corpus. Its name belongs to the CORPUS of its
// program in CMakeLists.txt, which makes one line of all that are skipped.
#define REQUIRE_CORPUS()                                                                           \
    if (::tractus::corpus().empty())                                                               \
    GTEST_SKIP() << "TRACTUS_CORPUS is not set: this test needs the folder of recordings"
