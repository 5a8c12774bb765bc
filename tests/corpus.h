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

// Returns the path of a file or folder in tests/data, which is distributed with the tests. Tests
// run in the folder of a build, below the sources; the compiler may know this file relative to
// either.
inline std::filesystem::path shipped(std::filesystem::path const& name)
{
    std::filesystem::path const here = __FILE__;
    auto folder = std::filesystem::current_path();
    while (!std::filesystem::exists(folder / here) && folder.has_relative_path())
        folder = folder.parent_path();
    return (folder / here).parent_path() / "data" / name;
}

} // namespace tractus

// Skips the running test, with a message, if there is no corpus. The test's name must be listed in
// CORPUS of its program in CMakeLists.txt, which prints one line for all skipped tests.
#define REQUIRE_CORPUS()                                                                           \
    if (::tractus::corpus().empty())                                                               \
    GTEST_SKIP() << "TRACTUS_CORPUS is not set: this test needs the folder of recordings"
