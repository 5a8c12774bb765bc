#pragma once

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace tractus {

// Returns the folder named by the environment variable TRACTUS_CORPUS, or an empty path if it is
// not set. The folder has recordings, descriptors, models and strokes that may not be distributed
// with the program.
inline std::filesystem::path corpus()
{
    char const* const folder = std::getenv("TRACTUS_CORPUS");
    return folder ? std::filesystem::path(folder) : std::filesystem::path();
}

// Returns the path of a file or folder in tests/data, which is distributed with the tests. Tests
// run in the folder of a build, below the sources. The compiler may give the path of this header
// relative to either folder.
inline std::filesystem::path shipped(std::filesystem::path const& name)
{
    std::filesystem::path const here = __FILE__;
    auto folder = std::filesystem::current_path();
    while (!std::filesystem::exists(folder / here) && folder.has_relative_path())
        folder = folder.parent_path();
    return (folder / here).parent_path() / "data" / name;
}

} // namespace tractus

// Skips the running test, with a message, if there is no corpus. The test's name must be listed
// after CORPUS of its test program in CMakeLists.txt, which prints one line for all skipped tests.
#define REQUIRE_CORPUS()                                                                           \
    if (::tractus::corpus().empty())                                                               \
    GTEST_SKIP() << "TRACTUS_CORPUS is not set: this test needs the folder of recordings"
