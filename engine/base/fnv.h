#pragma once

#include <cstdint>
#include <string_view>

namespace tractus {

// FNV-1a hash (Fowler, Noll, Vo). The same on every machine; not cryptographic.
constexpr std::uint32_t fnv1a_32(std::string_view text)
{
    std::uint32_t hash = 2166136261u;
    for (char const letter : text)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
    return hash;
}

constexpr std::uint64_t fnv1a_64(std::string_view text)
{
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (char const letter : text)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3u;
    return hash;
}

} // namespace tractus
