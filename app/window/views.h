#pragma once

#include "app/render/renderer.h"
#include "app/view/steady_frame.h"
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

// A picture inside the window. It is rendered again only when its contents have changed.
class ViewCanvas {
public:
    // Returns the canvas, resized to `size_px`. Sets `changed` if its size was different before.
    render::Canvas& sized(ImVec2 const& size_px, bool& changed);

    // Draws the canvas at ImGui's cursor.
    void show() const;

private:
    std::optional<render::Canvas> canvas_;
};

// Curves on the graphics card. They are made again only when they have changed.
class FollowedCurves {
public:
    // Makes the curves again with `make` if the revision or the palette differs from that at the
    // last call. Returns true if it did so.
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

// The views of Streit 2006 section 3; the view of drawn curves is in strokes_view.h. Each view
// draws at ImGui's cursor, in an area of `size_px`, and needs the OpenGL context of the window to
// be current.

// The drawing pad. It looks down through the surface, at the surface's current height, into the
// drawing volume. Nothing above the surface is shown. Lines become thinner with their depth below
// it.
class PadView {
public:
    // Draws the pad. The surface's active area is shown at `area`, in the middle of the view.
    void show(view::WindowState const& state, render::Renderer& renderer, PenArea const& area,
              ImVec2 const& size_px);

private:
    ViewCanvas canvas_;
    FollowedCurves skeleton_;
    FollowedCurves preview_;
    FollowedCurves strokes_;
    FollowedCurves live_;
    std::optional<render::GpuPicture> picture_;
    // Image that picture_ contains. Shared with the state.
    std::shared_ptr<render::Image const> shown_picture_;
    std::uint64_t picture_revision_ = 0;
    Eigen::Affine3f T_pad_world_ = Eigen::Affine3f::Identity();
    std::uint64_t turns_ = 0; // Number of times that T_pad_world_ has changed.
    double px_per_mm_ = 0;
};

// Changes the view of the skeleton by the mouse over ImGui's last item: turns, zooms and moves it.
// A drag with the right button, or with the left one if `left_turns`, does what `drag` says; with
// Shift it moves the view. `area` gives the scale in pixels per millimetre.
void turn_skeleton(scene::SelectionAngle& angle, PenArea const& area, bool left_turns,
                   ViewDrag drag);
void zoom(scene::SelectionAngle& angle, double factor);

// The view in which branches are selected. It shows the plant's skeleton, coloured by the states of
// its branches.
class SkeletonView {
public:
    // Draws the skeleton. The surface's active area is shown at `area`, in the middle of the view.
    void show(view::WindowState const& state, render::Renderer& renderer,
              scene::SelectionAngle const& angle, PenArea const& area, ImVec2 const& size_px);

    // Returns the states of branches that were shown in the last frame.
    SkeletonStates const& states() const { return states_; }

private:
    ViewCanvas canvas_;
    FollowedCurves curves_;
    SkeletonStates states_;
    FollowedCurves preview_;
    scene::SelectionAngle angle_;
    double px_per_mm_ = 0;
};

// The view of the whole plant, shaded. It is turned, moved and zoomed like that of the skeleton. It
// always has room for the fully grown plant, so that a younger plant looks smaller.
class PlantView {
public:
    // Shows the plant, and the branches that the current stroke would make or move.
    void show(view::WindowState const& state, render::Renderer& renderer, ImVec2 const& size_px,
              ViewDrag drag);

    // Shows the plant, and what grows along the current stroke. There is some space around the
    // plant, so that the view need not change while something grows. `may_turn`: dragging and the
    // wheel turn the view.
    void show_on_stage(view::WindowState const& state, render::Renderer& renderer,
                       ImVec2 const& size_px, ViewDrag drag, bool may_turn);

    // zoom() changes the view's zoom, and look_at_whole() resets the view, for the buttons of the
    // view tool.
    void zoom(double factor);
    void look_at_whole();

    // Renders the plant as the view shows it now, for a file. Empty before the first plant.
    render::Image picture(render::Renderer& renderer, int width, int height) const;

private:
    bool follow_plant(view::WindowState const& state);
    void follow_first_plant(double scale);
    void draw(render::Renderer& renderer, Bounds const& framed_mm, render::Canvas const& canvas,
              render::GpuCurves const* curves);

    ViewCanvas canvas_;
    Orbit orbit_;
    std::optional<render::GpuMesh> mesh_;
    // Lines along those parts of the plant in mesh_ that are below the ground.
    std::optional<render::GpuCurves> underground_;
    FollowedCurves growing_;
    Bounds framed_mm_; // Box to which the camera is fitted.
    // Box to which the camera is fitted in the stage view: everything that the stage view has shown
    // so far.
    Bounds framed_on_stage_mm_;
    std::uint64_t revision_ = 0;
    // True if mesh_ is the first plant of a sheet and still being drawn. The stage shows its
    // branches instead.
    bool is_first_ = false;
    view::SteadyFrame first_frame_ {};
    bool turned_ = false;
    bool is_light_ = false;
    bool was_on_stage_ = false; // True if the stage view was shown in the last frame.
    // Revision of the plant when something last grew beside the plant.
    std::optional<std::uint64_t> grows_on_ {};
};

} // namespace tractus::window
