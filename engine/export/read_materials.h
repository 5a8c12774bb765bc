#pragma once

#include "engine/export/tinygltf.h"
#include "engine/plant/material.h"

#include <Eigen/Geometry>
#include <vector>

namespace tractus::exports {

// Reads the materials of a glTF file, in the file's order: name, base colour, roughness, metalness,
// translucency (KHR_materials_diffuse_transmission), and pictures. A picture is read if the file
// contains it as PNG or JPEG and it uses the first texture coordinates. A texture that is used
// several times is stored once.
//
// Kind and translucency come from the extras that our own files have. In other files two-sided
// materials become leaves, all others solids. Alpha blending becomes Alpha::Mask, which shows the
// parts where alpha is at least one half.
std::vector<Material> read_materials(tinygltf::Model const& model);

// Returns the transform that a material applies to texture coordinates (KHR_texture_transform). It
// is that of the material's colour picture or, if it has none, of its first other picture. It is
// used for all pictures of the material, even if the file has a different one for each.
Eigen::Affine2f texture_transform(tinygltf::Material const& material);

} // namespace tractus::exports
