#pragma once

#include "app/render/renderer.h"
#include "app/window/orbit.h"
#include "app/window/palette.h"
#include "app/window/pen_area.h"
#include "app/window/view_curves.h"
#include "app/window/workspace.h"

#include <imgui.h>
#include <memory>
#include <optional>
#include <utility>

namespace tractus::window {

// A picture inside the window, rendered again only when its contents have changed.
class ViewCanvas {
public:
    // Returns the canvas resized; sets `changed` if it had another size.
    render::Canvas& sized(ImVec2 const& size_px, bool& changed);

    // Draws the picture at ImGui's cursor.
    void show() const;

private:
    std::optional<render::Canvas> canvas_;
};

// Curves on the graphics card, rebuilt only when they have changed.
class FollowedCurves {
public:
    // Rebuilds the curves with `make` if the revision or the palette differs from the last call's.
    // Returns true if it did.
    template<typename Make> bool follow(std::uint64_t revision, Make const& make)
    {
        bool const is_light = theme::palette().is_light;
        bool const same_colors = std::exchange(is_light_, is_light) == is_light;
        if (curves_ && revision == revision_ && same_colors)
            return false;
        curves_.emplace(make());
        revision_ = revision;
        return true;
    }

    render::GpuCurves const* curves() const { return &*curves_; }

private:
    std::optional<render::GpuCurves> curves_;
    std::uint64_t revision_ = 0;
    bool is_light_ = false;
};

// The views of Streit 2006 section 3; that of the drawn curves is in strokes_view.h. Each draws at
// ImGui's cursor, `size_px` large, and needs the window's OpenGL context to be current.

// Looks down through the surface at its current height into the drawing volume: nothing above the
// surface is shown, and lines get thinner with depth below it.
class PadView {
public:
    // The surface's active area is shown at `area`, in the middle of the view.
    void show(view::WindowState const& state, render::Renderer& renderer, PenArea const& area,
              ImVec2 const& size_px);

private:
    ViewCanvas canvas_;
    FollowedCurves skeleton_;
    FollowedCurves preview_;
    FollowedCurves strokes_;
    FollowedCurves live_;
    std::optional<render::GpuPicture> picture_;
    // The image from which picture_ was uploaded.
    std::shared_ptr<render::Image const> shown_picture_;
    std::uint64_t picture_revision_ = 0;
    Eigen::Affine3f T_pad_world_ = Eigen::Affine3f::Identity();
    std::uint64_t turns_ = 0; // Number of times that T_pad_world_ has changed.
    double px_per_mm_ = 0;
};

// Turns, zooms and moves the skeleton's view by the mouse over ImGui's last item. A drag with the
// right button, or with the left one if `left_turns`, does `drag`; with Shift it moves. `area`
// gives the scale, pixels per millimetre.
void turn_skeleton(scene::SelectionAngle& angle, PenArea const& area, bool left_turns,
                   ViewDrag drag);
void zoom(scene::SelectionAngle& angle, double factor);

// The plant's skeleton, coloured by the states of its branches, in which branches are selected.
class SkeletonView {
public:
    // The surface's active area is shown at `area`, in the middle of the view.
    void show(view::WindowState const& state, render::Renderer& renderer,
              scene::SelectionAngle const& angle, PenArea const& area, ImVec2 const& size_px);

    // The states shown in the last frame.
    SkeletonStates const& states() const { return states_; }

private:
    ViewCanvas canvas_;
    FollowedCurves curves_;
    SkeletonStates states_;
    FollowedCurves preview_;
    scene::SelectionAngle angle_;
    double px_per_mm_ = 0;
};

// The whole plant, shaded; turned, moved and zoomed like the skeleton. The frame fits the
// full-grown plant, so that a younger one looks smaller.
class PlantView {
public:
    void show(view::WindowState const& state, render::Renderer& renderer, ImVec2 const& size_px,
              ViewDrag drag);

    // Shows the plant together with what grows along the current stroke, with some space around it
    // so that the frame need not change meanwhile. `may_turn`: drags and the wheel turn it.
    void show_on_stage(view::WindowState const& state, render::Renderer& renderer,
                       ImVec2 const& size_px, ViewDrag drag, bool may_turn);

    // Zooms the view, for the buttons of the view tool; look_at_whole() resets it.
    void zoom(double factor);
    void look_at_whole();

    // Renders the current view for a file. Empty before the first plant.
    render::Image picture(render::Renderer& renderer, int width, int height) const;

private:
    bool follow_plant(view::WindowState const& state);
    void draw(render::Renderer& renderer, Bounds const& framed_mm, render::Canvas const& canvas,
              render::GpuCurves const* curves);

    ViewCanvas canvas_;
    Orbit orbit_;
    std::optional<render::GpuMesh> mesh_;
    std::optional<render::GpuCurves> underground_; // Parts of the plant in mesh_ below the ground.
    FollowedCurves growing_;
    Bounds framed_mm_; // Box that the orbit looks at.
    // Box that the orbit looks at in the stage view: everything shown there so far.
    Bounds framed_on_stage_mm_;
    std::uint64_t revision_ = 0;
    bool turned_ = false;
    bool is_light_ = false;
    bool was_on_stage_ = false; // True if the stage view was active in the last frame.
    // Revision of the plant when something last grew beside it.
    std::optional<std::uint64_t> grows_on_ {};
};

} // namespace tractus::window
