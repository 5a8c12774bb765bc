#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>

namespace tractus {

// A file's bytes; empty where there is no such file. Read at once: character by character,
// unoptimised as tests are, the larger files that the program writes took longer to read than to
// make.
inline std::string file_bytes(std::filesystem::path const& path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::string bytes(file ? static_cast<std::size_t>(file.tellg()) : 0, '\0');
    file.seekg(0);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

} // namespace tractus
