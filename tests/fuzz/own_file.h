#pragma once

#include <filesystem>
#include <fmt/core.h>
#include <string>
#include <unistd.h>

namespace tractus {

// Returns the path of this process's file with an ending: in memory if the system has /dev/shm,
// otherwise in the folder for temporary files.
inline std::filesystem::path own_file(std::string const& ending)
{
    std::filesystem::path const memory = "/dev/shm";
    auto const folder = exists(memory) ? memory : std::filesystem::temp_directory_path();
    return folder / fmt::format("tractus-fuzzer-{}{}", getpid(), ending);
}

} // namespace tractus
