#pragma once

#include "engine/export/glb_writer.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tractus::io {

// A .glb file that draws more triangles than this takes long to open in many programs.
constexpr std::uint64_t kManyTriangles = 5'000'000;

// A .glb file of more bytes than this is large, too.
constexpr std::uint64_t kManyBytes = 100'000'000;

// Describes the size of a large file, as part of a sentence. No value for a smaller file.
std::optional<std::string> large_glb_size(exports::GlbSummary const& summary);

// Returns a note to print before a large file is written: the expected size, and the options that
// reduce it. No value for a smaller file.
std::optional<std::string> large_glb_note(exports::GlbSummary const& expected,
                                          exports::GlbOptions const& options);

} // namespace tractus::io
