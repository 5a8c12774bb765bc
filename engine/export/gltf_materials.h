#pragma once

#include "engine/export/glb_stream.h"
#include "engine/export/gltf_json.h"
#include "engine/plant/material.h"

#include <map>
#include <string>
#include <string_view>

namespace tractus::exports {

// The materials of a glTF file, with their pictures. Equal materials and pictures are written once.
class GltfMaterials {
public:
    // Writes materials to `json`, and pictures to `stream` if `has_textures`. `bark_px`: as in
    // GlbOptions.
    GltfMaterials(GltfJson& json, GlbStream& stream, bool has_textures, int bark_px);

    // Returns the index of a material, adding it unless an equal one exists.
    std::size_t index_of(Material const& material);

    // Adds a material for a billboard, a picture with transparency that is displayed without
    // lighting (KHR_materials_unlit), and returns its index. Every call adds a new material.
    std::size_t add_picture(std::string_view png);

private:
    std::size_t add_texture(std::string_view bytes, TexturePicture::Edges edges);
    void refer(Json& to, char const* name, TextureSlot const& slot);

    GltfJson& json_;
    GlbStream& stream_;
    bool has_textures_;
    int bark_px_;
    std::map<std::string, std::size_t> textures_; // Texture indices, by the picture's bytes.
    std::map<std::string, std::size_t> indices_;  // Material indices, by the material's JSON.
};

} // namespace tractus::exports
