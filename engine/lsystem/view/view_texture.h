#pragma once

#include "engine/lsystem/view/view_reader.h"
#include "engine/plant/material.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// The picture of a material's surfaces: texture= of a material: statement (view.h).
constexpr std::size_t kMostTextureBytes = std::size_t { 16 } << 20;
constexpr std::int64_t kMostTexturePixels = 16'000'000;

// Lets the material show a picture, and have its mean colour for who shows none: linear light of
// the pixels that are at least half there. The rows of the material's own picture begin with the
// file's last one, since v is 0 at the base of organs (engine/mesh/mesh.h). Fails, as the user's
// fault, in a sentence without the file's name, for what is no PNG file, and for more bytes or
// pixels than there may be.
Result<void> put_texture(Material& material, std::string_view png);

// Lets the material show the picture in the file of that name in the model's folder, as
// put_texture() does. A file that cannot be read is a warning.
Result<void> read_texture(ViewReader& reader, Material& material, std::string const& name);

} // namespace tractus::lsystem
