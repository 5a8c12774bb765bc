#pragma once

#include "app/window/controls.h"
#include "app/window/glyph_picture.h"

#include <cstddef>
#include <imgui.h>
#include <optional>

namespace tractus::window {

// The tool in hand, or what has been drawn with it, as a small drawing in a corner of the pad,
// whose handles are dragged by pen or mouse (app/tools/glyph.h). What has been drawn is shown as it
// will follow, and does when the handle is let go.
class GlyphPanel {
public:
    explicit GlyphPanel(float scale)
        : scale_(scale)
    {
    }

    // Shows it in the upper right corner of `pad`, if the tool has one and there is room. Returns
    // where it is; no value: nowhere.
    std::optional<WindowPart> show(view::WindowModel& model, Workbench& bench,
                                   Controls const& controls, WindowPart const& pad);

private:
    void say_what_is_shown(tools::Glyph const& glyph) const;
    void show_glyph(view::WindowModel& model, Workbench& bench, tools::Glyph const& glyph,
                    GlyphSquare const& square);
    void take_hand(view::WindowModel& model, Workbench& bench, tools::Glyph::Handle const& handle,
                   GlyphSquare const& square);
    void press(view::WindowModel& model, Workbench& bench,
               tools::Glyph::Handle const& handle) const;
    void move(view::WindowModel& model, Workbench& bench, tools::Glyph::Handle const& handle,
              Vec2 const& to);
    void let_go(view::WindowModel& model, Workbench& bench, tools::Glyph::Handle const& handle);
    void draw_labels(tools::Glyph const& glyph, GlyphSquare const& square) const;
    void draw_handle(tools::Glyph::Handle const& handle, GlyphSquare const& square) const;

    float scale_ = 1;
    std::optional<std::size_t> held_ {};  // A handle's id.
    std::optional<std::size_t> shown_ {}; // The one that was held or pointed at last.
    ImVec2 off_px_ { 0, 0 };              // From where it was taken to the handle.
    std::optional<Vec2> moved_to_ {};     // Place of the handle that is held, if it has moved.
};

} // namespace tractus::window
