#pragma once

#include "engine/export/glb_writer.h"

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>

namespace tractus::exports {

inline GlbOptions const kInstanced { .organs = GlbOptions::Organs::Instanced };

// Returns the bytes of a .glb file that contains plants.
inline std::string glb_of(std::span<PlacedMesh const> plants, GlbOptions const& options = {})
{
    std::ostringstream out;
    auto const summary = write_glb(out, plants, options);
    EXPECT_TRUE(summary) << summary.error().message;
    EXPECT_EQ(summary->bytes, out.str().size());
    return out.str();
}

inline std::string glb_of(mesh::Mesh const& mesh, GlbOptions const& options = {})
{
    PlacedMesh const placed { .mesh = &mesh };
    return glb_of(std::span(&placed, 1), options);
}

// Returns the JSON of a .glb file, which is its first chunk.
inline nlohmann::json json_of(std::string const& glb)
{
    std::uint32_t size = 0;
    std::memcpy(&size, glb.data() + 12, sizeof size);
    return nlohmann::json::parse(glb.substr(20, size));
}

} // namespace tractus::exports
