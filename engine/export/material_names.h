#pragma once

#include "engine/plant/material.h"

#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace tractus::exports {

// Names for the materials of a file. Different materials get different names, and equal materials
// the same name. Materials are equal if they look the same in every format: by their name, kind,
// numbers and pictures.
class MaterialNames {
public:
    // `word` turns a material's name into one that the file's format allows. `mark` separates a
    // name from the number that tells it from an equal name of another material.
    MaterialNames(std::function<std::string(std::string const&)> word, char mark);

    struct Named {
        std::string name;
        bool is_new; // True if no earlier call had an equal material.
    };

    Named name_of(Material const& material);

private:
    using Key = std::tuple<std::string, Material::Kind, std::array<float, 8>,
                           std::array<TexturePicture const*, 5>, MaterialTextures::Alpha,
                           MaterialTextures::Color, Bark>;
    static Key key_of(Material const& material);
    std::string unused_name(std::string const& word);

    std::function<std::string(std::string const&)> word_;
    char mark_;
    std::map<Key, std::string> names_;
    std::set<std::string> used_;
};

} // namespace tractus::exports
