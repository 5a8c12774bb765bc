#pragma once

#include "engine/export/tinygltf.h"
#include "engine/plant/material.h"

#include <Eigen/Geometry>
#include <vector>

namespace tractus::exports {

// The materials of a glTF file, in its order: name, base colour, roughness, metal, how much light
// passes (KHR_materials_diffuse_transmission), and the pictures of each, those of the normals and
// of occlusion too, where the file holds them as PNG or JPEG and the first texture coordinates
// place them. A picture that several materials or slots show is one picture.
//
// Kind and translucency are kept in our own files' extras; in others' files what is double-sided is
// taken for leaves and the rest for solids. What blends is shown where it is more than half there.
std::vector<Material> read_materials(tinygltf::Model const& model);

// What a material does to the texture coordinates of its meshes (KHR_texture_transform): that of
// its picture of colours or, without one, of the first other picture. Files that place a material's
// pictures differently are shown as if they did not.
Eigen::Affine2f texture_transform(tinygltf::Material const& material);

} // namespace tractus::exports
