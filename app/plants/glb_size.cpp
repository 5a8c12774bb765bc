#include "app/plants/glb_size.h"

#include <fmt/format.h>

namespace tractus {

std::optional<std::string> large_glb_note(GlbSummary const& expected, GlbOptions::Organs organs)
{
    if (expected.triangles <= kManyTriangles)
        return std::nullopt;
    auto const* const instanced = organs == GlbOptions::Organs::Instanced
        ? ""
        : "--organs instanced is smaller for programs that know EXT_mesh_gpu_instancing; ";
    return fmt::format(
        "the .glb will have about {:.1f} million triangles and {:.0f} MB, which "
        "takes long to open: {}\"tractus vary\" has --sides, --quantized and --lods, "
        "and writes a file for each plant into a folder",
        static_cast<double>(expected.triangles) / 1e6, static_cast<double>(expected.bytes) / 1e6,
        instanced);
}

} // namespace tractus
