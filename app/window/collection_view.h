#pragma once

#include "app/window/views.h"

#include <cstdint>
#include <map>
#include <vector>

namespace tractus::window {

// A sheet of variations of the plant, each with its seed; the one that is pressed becomes the
// plant. They come one by one, and each is drawn once, when it comes.
class CollectionView {
public:
    // Asks for variations of the plant as it is now.
    static void begin(view::WindowModel& model);

    // At ImGui's cursor, `size_px` large.
    void show(view::WindowModel& model, render::Renderer& renderer, ImVec2 const& size_px);

private:
    struct Picture {
        mesh::Mesh const* mesh = nullptr; // That it shows: the model holds it.
        ViewCanvas canvas;
    };

    void draw(view::VariationView const& variation, Picture& picture, render::Renderer& renderer,
              ImVec2 const& size_px) const;

    std::map<std::uint64_t, Picture> pictures_; // By seed.
    bool is_light_ = false;
};

} // namespace tractus::window
