#pragma once

#include "app/window/orbit.h"
#include "app/window/views.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::window {

// The curves that the user has drawn (Streit 2006 section 3, the left pane), with their numbers, in
// a view that turns, moves and zooms like the plant's; and a list of their names.
class StrokesView {
public:
    // Draws the view at ImGui's cursor, `size_px` large. Returns the index of a curve that was
    // clicked in this frame.
    std::optional<std::size_t> show(view::WindowState const& state, render::Renderer& renderer,
                                    ImVec2 const& size_px, ViewDrag drag);

    // Draws the list at ImGui's cursor, the newest curve last; returns as show() does.
    std::optional<std::size_t> show_list(view::WindowState const& state, ImVec2 const& size_px);

    // Writes the highlighted curve's number and name, or the number of highlighted curves, above
    // `corner_px`, the lower left corner.
    void show_caption(view::WindowState const& state, ImVec2 const& corner_px) const;

    // Change the view's zoom, for the buttons of the view tool; look_at_whole() resets the view.
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
    FollowedCurves ground_;
    std::vector<std::size_t> highlighted_;
    std::optional<std::size_t> picked_; // Picked curve; reset when a curve is added or removed.
    std::size_t curve_count_ = 0;
    std::uint64_t newest_edit_ = 0;
    std::uint64_t picks_ = 0; // Number of changes of picked_.
    bool turned_ = false;
    bool list_is_behind_ = true; // True if the list has to scroll to its end.
};

} // namespace tractus::window
