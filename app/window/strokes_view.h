#pragma once

#include "app/window/orbit.h"
#include "app/window/views.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::window {

// View of the curves that the user has drawn (Streit 2006 section 3, the left pane), with their
// numbers. It turns, moves and zooms like the plant's view. There is also a list of the curves'
// names.
class StrokesView {
public:
    // Draws the view at ImGui's cursor, in an area of `size_px`. Returns the index of the curve
    // that was clicked in this frame.
    std::optional<std::size_t> show(view::WindowState const& state, render::Renderer& renderer,
                                    ImVec2 const& size_px, ViewDrag drag);

    // Draws the list of curves at ImGui's cursor, with the newest curve last. Returns the index of
    // the curve that was clicked in this frame.
    std::optional<std::size_t> show_list(view::WindowState const& state, ImVec2 const& size_px);

    // Writes the highlighted curve's number and name, or how many curves are highlighted.
    // `corner_px` is the lower left corner of the text.
    void show_caption(view::WindowState const& state, ImVec2 const& corner_px) const;

    // zoom() changes the view's zoom, and look_at_whole() resets the view, for the buttons of the
    // view tool.
    void zoom(double factor);
    void look_at_whole();

private:
    void follow(view::WindowState const& state);
    void pick(std::optional<std::size_t> curve);
    void draw_labels(view::WindowState const& state, ImVec2 const& corner_px,
                     ImVec2 const& size_px) const;
    void show_row(view::WindowState const& state, std::size_t curve, float width_px,
                  std::optional<std::size_t>& pressed) const;

    ViewCanvas canvas_;
    Orbit orbit_;
    FollowedCurves curves_;
    FollowedCurves live_;
    FollowedCurves ground_;
    std::vector<std::size_t> highlighted_;
    std::optional<std::size_t> picked_; // Picked curve; reset when a curve is added or removed.
    std::size_t curve_count_ = 0;
    std::uint64_t newest_edit_ = 0;
    std::uint64_t picks_ = 0; // Number of times that picked_ has changed.
    bool turned_ = false;
    bool list_is_behind_ = true; // True if the list must scroll to its end.
};

} // namespace tractus::window
