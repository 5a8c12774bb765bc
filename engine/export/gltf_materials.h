#pragma once

#include "engine/export/glb_stream.h"
#include "engine/export/gltf_json.h"
#include "engine/plant/material.h"

#include <map>
#include <string>
#include <string_view>

namespace tractus::exports {

// The materials of a glTF file, and the pictures of bark and of a leaf's veins that they use. What
// is equal is there once.
class GltfMaterials {
public:
    // Puts materials into `json`, and pictures into `stream` unless they are not wanted.
    GltfMaterials(GltfJson& json, GlbStream& stream, bool has_textures);

    // Returns the material's index, which is new if no equal one has come before.
    std::size_t index_of(Material const& material);

    // A material that is all picture: transparent where that is, and lit as it was drawn
    // (KHR_materials_unlit). Always new.
    std::size_t add_picture(std::string_view png);

private:
    std::size_t add_texture(std::string_view bytes, TexturePicture::Edges edges);
    void refer(Json& to, char const* name, TextureSlot const& slot);

    GltfJson& json_;
    GlbStream& stream_;
    bool has_textures_;
    std::map<std::string, std::size_t> textures_; // Keyed by their bytes: few, each there once.
    std::map<std::string, std::size_t> indices_;  // Keyed by their JSON.
};

} // namespace tractus::exports
