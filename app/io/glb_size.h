#pragma once

#include "engine/export/glb_writer.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tractus::io {

// Triangles, as drawn, above which many programs take long to open a file.
constexpr std::uint64_t kManyTriangles = 5'000'000;

// How large such a file is, as a part of a sentence. Nothing for smaller ones.
std::optional<std::string> large_glb_size(exports::GlbSummary const& summary);

// Returns what to say before such a file is written: how large it will be, and the options that
// make it smaller. Nothing for smaller ones.
std::optional<std::string> large_glb_note(exports::GlbSummary const& expected,
                                          exports::GlbOptions const& options);

} // namespace tractus::io
