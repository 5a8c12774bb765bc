#pragma once

#include "app/window/views.h"

#include <cstdint>
#include <map>
#include <vector>

namespace tractus::window {

// A sheet of variations of the plant, each with its seed; pressing one makes it the plant. They
// arrive one by one, and each is rendered once, when it arrives.
class CollectionView {
public:
    // Requests variations of the current plant.
    static void begin(view::WindowModel& model);

    // Shows the sheet at ImGui's cursor, `size_px` large.
    void show(view::WindowModel& model, render::Renderer& renderer, ImVec2 const& size_px);

private:
    struct Picture {
        mesh::Mesh const* mesh = nullptr; // The mesh that the picture shows; owned by the model.
        ViewCanvas canvas;
    };

    void draw(view::VariationView const& variation, Picture& picture, render::Renderer& renderer,
              ImVec2 const& size_px) const;

    std::map<std::uint64_t, Picture> pictures_; // Pictures of the variations, by seed.
    bool is_light_ = false;
};

} // namespace tractus::window
