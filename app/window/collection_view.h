#pragma once

#include "app/window/views.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace tractus::window {

// Returns the number of columns in which `count` pictures, side by side on a sheet of `size_px`,
// show plants at the largest size. `shape` is the plants' width as a share of their height.
std::size_t sheet_columns(std::size_t count, ImVec2 const& size_px, double shape);

// A sheet of variations of the plant at the same scale, each with its seed. A variation that is
// pressed replaces the plant. Variations appear one by one, as they are grown.
class CollectionView {
public:
    static constexpr std::size_t kVariations = 12;

    // begin() requests variations of the current plant; end() withdraws the request.
    static void begin(view::WindowModel& model);
    static void end(view::WindowModel& model);

    // Shows the sheet at ImGui's cursor, in an area of `size_px`.
    void show(view::WindowModel& model, render::Renderer& renderer, ImVec2 const& size_px);

private:
    struct Picture {
        mesh::Mesh const* mesh = nullptr; // Mesh that the picture shows. Owned by the model.
        std::uint64_t revision = 0; // Revision of the collection when the picture's scale was set.
        ViewCanvas canvas;
    };

    void draw(view::WindowState const& state, view::VariationView const& variation,
              Picture& picture, render::Renderer& renderer, ImVec2 const& size_px) const;

    std::map<std::uint64_t, Picture> pictures_; // Pictures of the variations, by seed.
    double shape_ = 1;                 // Width of the variations, as a share of their height.
    std::uint64_t shape_revision_ = 0; // Revision of the collection when shape_ was computed.
    bool is_light_ = false;
};

} // namespace tractus::window
