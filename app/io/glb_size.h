#pragma once

#include "engine/export/glb_writer.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tractus::io {

// Number of drawn triangles above which many programs take long to open a file.
constexpr std::uint64_t kManyTriangles = 5'000'000;

// Describes the size of a large file, as a part of a sentence. No value for smaller ones.
std::optional<std::string> large_glb_size(exports::GlbSummary const& summary);

// Note to print before a large file is written: its expected size, and the options that reduce it.
// No value for smaller ones.
std::optional<std::string> large_glb_note(exports::GlbSummary const& expected,
                                          exports::GlbOptions const& options);

} // namespace tractus::io
