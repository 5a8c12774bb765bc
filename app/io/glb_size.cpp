#include "app/io/glb_size.h"

#include <fmt/format.h>

namespace tractus::io {

std::optional<std::string> large_glb_size(exports::GlbSummary const& summary)
{
    if (summary.triangles <= kManyTriangles && summary.bytes <= kManyBytes)
        return std::nullopt;
    return fmt::format("about {:.1f} million triangles and {:.0f} MB, which takes long to open",
                       static_cast<double>(summary.triangles) / 1e6,
                       static_cast<double>(summary.bytes) / 1e6);
}

std::optional<std::string> large_glb_note(exports::GlbSummary const& expected,
                                          exports::GlbOptions const& options)
{
    auto const size = large_glb_size(expected);
    if (!size)
        return std::nullopt;
    auto const compressed = options.vertices == exports::GlbOptions::Vertices::Compressed
        ? std::string()
        : fmt::format("--compressed makes about {:.0f} MB for programs that know "
                      "EXT_meshopt_compression; ",
                      static_cast<double>(expected.compressed_bytes) / 1e6);
    auto const* const quantized = options.vertices != exports::GlbOptions::Vertices::Float
        ? ""
        : "--quantized is smaller for programs that know KHR_mesh_quantization; ";
    auto const* const instanced = options.organs == exports::GlbOptions::Organs::Instanced
        ? ""
        : "--organs instanced is smaller for programs that know EXT_mesh_gpu_instancing; ";
    auto const files = expected.files == 1
        ? std::string("the .glb")
        : fmt::format("the {} .glb files together", expected.files);
    return fmt::format("{} will have {}: {}{}{}\"tractus vary\" has --sides and --lods{}", files,
                       *size, compressed, quantized, instanced,
                       expected.files == 1 ? ", and writes a file for each plant into a folder"
                                           : "");
}

} // namespace tractus::io
