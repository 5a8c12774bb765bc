#pragma once

#include "engine/lsystem/view/view_reader.h"
#include "engine/plant/material.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Textures of materials: the texture= field of a material: statement (view.h).
constexpr std::size_t kMaxTextureBytes = std::size_t { 16 } << 20;
constexpr std::int64_t kMaxTexturePixels = 16'000'000;

// Gives a material a picture. For renderers that show no pictures, the material's colour becomes
// the mean, in linear light, of the pixels with an alpha of at least one half. The rows are stored
// in reverse order, the file's last row first, because v is 0 at the base of organs
// (engine/mesh/mesh.h). Fails with a user error if the data are not a PNG file or have too many
// bytes or pixels; the message does not name the file.
Result<void> put_texture(Material& material, std::string_view png);

// Gives a material the picture in a file of the model's folder, as put_texture() does. If the file
// cannot be read, only warns.
Result<void> read_texture(ViewReader& reader, Material& material, std::string const& name);

} // namespace tractus::lsystem
