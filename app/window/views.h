#pragma once

#include "app/render/renderer.h"
#include "app/window/orbit.h"
#include "app/window/palette.h"
#include "app/window/pen_area.h"
#include "app/window/view_curves.h"
#include "app/window/workbench.h"

#include <imgui.h>
#include <memory>
#include <optional>
#include <utility>

namespace tractus::window {

// A picture inside the window: a canvas that is drawn again only when what it shows has changed.
class ViewCanvas {
public:
    // The canvas in this size; `changed` becomes true if it had another one.
    render::Canvas& sized(ImVec2 const& size_px, bool& changed);

    // Puts the picture at ImGui's cursor.
    void show() const;

private:
    std::optional<render::Canvas> canvas_;
};

// Curves on the graphics card that are made again only when they have changed.
class FollowedCurves {
public:
    // True if they were made, by `make`, since the revision is another one than at the last call,
    // or the colours are.
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

// The three views of Streit 2006 section 3. Each draws itself at ImGui's cursor, `size_px` large,
// with the window's context current.

// Looks from above into the drawing volume through the surface at its present height: nothing above
// the surface is seen, and lines get thinner with the depth below it.
class PadView {
public:
    // The surface's area is seen where `area` has it, in the middle of the view.
    void show(view::WindowState const& state, render::Renderer& renderer, PenArea const& area,
              ImVec2 const& size_px);

private:
    ViewCanvas canvas_;
    FollowedCurves skeleton_;
    FollowedCurves preview_;
    FollowedCurves strokes_;
    FollowedCurves live_;
    std::optional<render::GpuPicture> picture_;
    std::shared_ptr<render::Image const> shown_picture_; // Picture that it is made of.
    std::uint64_t picture_revision_ = 0;
    Eigen::Affine3f T_pad_world_ = Eigen::Affine3f::Identity();
    std::uint64_t turns_ = 0; // Of that.
    double px_per_mm_ = 0;
};

// Turns, zooms and moves the skeleton's view by what the mouse does over ImGui's last item: drags
// with the right button, or with the left one if `left_turns`, mean `drag`; with Shift they move
// it. Tablet millimetres are as `area` shows them.
void turn_skeleton(scene::SelectionAngle& angle, PenArea const& area, bool left_turns,
                   ViewDrag drag);
void zoom(scene::SelectionAngle& angle, double factor);

// The plant's skeleton with the states of its branches, as it is selected from.
class SkeletonView {
public:
    // The tablet's area is seen where `area` has it, in the middle of the view.
    void show(view::WindowState const& state, render::Renderer& renderer,
              scene::SelectionAngle const& angle, PenArea const& area, ImVec2 const& size_px);

    // What it showed.
    SkeletonStates const& states() const { return states_; }

private:
    ViewCanvas canvas_;
    FollowedCurves curves_;
    SkeletonStates states_;
    FollowedCurves preview_;
    scene::SelectionAngle angle_;
    double px_per_mm_ = 0;
};

// The whole plant, lit; turned, moved and zoomed like the skeleton. What it frames is the plant
// full-grown, so that a younger one is seen to be smaller.
class PlantView {
public:
    void show(view::WindowState const& state, render::Renderer& renderer, ImVec2 const& size_px,
              ViewDrag drag);

    // The plant with what grows along the stroke under way, and with room around it, so that the
    // picture keeps still meanwhile. `may_turn`: drags and the wheel turn it.
    void show_on_stage(view::WindowState const& state, render::Renderer& renderer,
                       ImVec2 const& size_px, ViewDrag drag, bool may_turn);

    // By what the view tool's buttons wish for.
    void zoom(double factor);
    void look_at_whole();

    // What is seen now, for a file. Empty before the first plant.
    render::Image picture(render::Renderer& renderer, int width, int height) const;

private:
    bool follow_plant(view::WindowState const& state);
    void draw(render::Renderer& renderer, Bounds const& framed_mm, render::Canvas const& canvas,
              render::GpuCurves const* curves);

    ViewCanvas canvas_;
    Orbit orbit_;
    std::optional<render::GpuMesh> mesh_;
    FollowedCurves growing_;
    Bounds framed_mm_;          // What the orbit looks at,
    Bounds framed_on_stage_mm_; // and on stage: all that has been there.
    std::uint64_t revision_ = 0;
    bool turned_ = false;
    bool is_light_ = false;
    bool was_on_stage_ = false; // In the last frame.
    // Revision of the plant beside which something grew last.
    std::optional<std::uint64_t> grows_on_ {};
};

} // namespace tractus::window
