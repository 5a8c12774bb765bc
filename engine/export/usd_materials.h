#pragma once

#include "engine/export/material_names.h"
#include "engine/export/picture_file.h"
#include "engine/export/usd_text.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tractus::exports {

// The materials of a USD file, as UsdPreviewSurface, with their pictures as files beside it. Equal
// materials and pictures are written once.
//
// Translucency is left out, since UsdPreviewSurface knows none. A default colour picture is
// multiplied by the material's colour beforehand, as in .mtl files; a material's own picture is
// multiplied by the texture's scale.
class UsdMaterials {
public:
    // `scope`: path of the prim in which write() is called. `stem`: how the names of pictures
    // begin; empty: there are no pictures.
    UsdMaterials(std::string scope, std::string stem);

    // Returns the path of a material, which write() will write.
    std::string path_of(Material const& material);

    // Writes all materials in a prim of their own. Call it once, after the last path_of().
    void write(UsdText& text);

    std::vector<PictureFile> take_pictures() { return std::move(pictures_); }

private:
    // A texture of a material: what is read from which picture.
    struct Texture {
        char const* name; // Of the shader prim, and in the picture's file name.
        std::string const& bytes;
        TexturePicture::Edges edges = TexturePicture::Edges::Repeat;
        bool is_color = false; // sRGB; otherwise the picture contains plain numbers.
        Vec3 scale = Vec3::Ones();
        Vec3 bias = Vec3::Zero();
    };

    void write(UsdText& text, std::string const& name, Material const& material);
    void write_surface(UsdText& text, Material const& material,
                       std::vector<Texture> const& textures) const;
    void write_texture(UsdText& text, std::string const& material, Texture const& texture);
    std::vector<Texture> textures_to_write(Material const& material,
                                           std::string const& color) const;
    std::string file_of(std::string const& material, Texture const& texture);

    std::string scope_;
    std::string stem_;
    MaterialNames names_;
    std::vector<std::pair<std::string, Material>> materials_; // In the order of path_of().
    std::map<std::string, std::string> files_; // Names of picture files, by their bytes.
    std::vector<PictureFile> pictures_;
};

} // namespace tractus::exports
