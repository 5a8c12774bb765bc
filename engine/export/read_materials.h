#pragma once

#include "engine/export/tinygltf.h"
#include "engine/plant/material.h"

#include <Eigen/Geometry>
#include <vector>

namespace tractus::exports {

// Reads the materials of a glTF file, in its order: name, base colour, roughness, metalness,
// translucency (KHR_materials_diffuse_transmission), and all pictures that the file contains as PNG
// or JPEG and that use the first texture coordinates. A picture used several times is stored once.
//
// Kind and translucency come from the extras that our own files have; in other files two-sided
// materials are taken as leaves and the others as solids. Materials with alpha blending are shown
// where their alpha is above one half.
std::vector<Material> read_materials(tinygltf::Model const& model);

// Returns the transform that a material applies to texture coordinates (KHR_texture_transform):
// that of its colour picture, or of its first other picture. Files with different transforms for
// the pictures of one material are displayed as if they were equal.
Eigen::Affine2f texture_transform(tinygltf::Material const& material);

} // namespace tractus::exports
