#pragma once

#include "app/window/views.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace tractus::window {

// Returns the number of columns in which `count` pictures side by side fill a sheet of `size_px`
// best: plants of that shape, their width as a share of their height, are then largest.
std::size_t sheet_columns(std::size_t count, ImVec2 const& size_px, double shape);

// A sheet of variations of the plant at one scale, each with its seed; pressing one makes it the
// plant. They arrive one by one.
class CollectionView {
public:
    static constexpr std::size_t kVariations = 12;

    // Requests variations of the current plant, and ends the request.
    static void begin(view::WindowModel& model);
    static void end(view::WindowModel& model);

    // Shows the sheet at ImGui's cursor, `size_px` large.
    void show(view::WindowModel& model, render::Renderer& renderer, ImVec2 const& size_px);

private:
    struct Picture {
        mesh::Mesh const* mesh = nullptr; // The mesh that the picture shows; owned by the model.
        std::uint64_t revision = 0; // Revision of the collection that set the picture's scale.
        ViewCanvas canvas;
    };

    void draw(view::WindowState const& state, view::VariationView const& variation,
              Picture& picture, render::Renderer& renderer, ImVec2 const& size_px) const;

    std::map<std::uint64_t, Picture> pictures_; // Pictures of the variations, by seed.
    double shape_ = 1;                 // Width of the variations as a share of their height.
    std::uint64_t shape_revision_ = 0; // Revision of the collection that has this shape.
    bool is_light_ = false;
};

} // namespace tractus::window
