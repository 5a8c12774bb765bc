#pragma once

#include "app/window/controls.h"
#include "app/window/hand_input.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus::window {

// A panel above the bar for a name, of the drawing, of a copy of it or of a card: typed on keys
// that a pen can press, or on a keyboard, where Enter confirms and Esc gives up. The name that is
// there at first is selected: what is typed takes its place, unless the field is pressed before.
class NamePanel {
public:
    explicit NamePanel(float scale)
        : scale_(scale)
    {
    }

    // Shows it for `bench.asked_name` above `bar`, and takes that back when it is done or closed.
    // `presses` are the keyboard's of this frame. Returns where it is.
    WindowPart show(view::WindowModel& model, Workbench& bench, Controls const& controls,
                    WindowPart const& bar, std::span<KeyPress const> presses);

private:
    void show_name(view::WindowModel& model, Workbench& bench, Controls const& controls,
                   float width);
    void take_keyboard(std::span<KeyPress const> presses);
    void take_letter(unsigned int letter);
    void take_back();
    void show_typed(char const* question, float width);
    void show_keys(Controls const& controls, float width);
    void show_row(std::string_view keys, Controls const& controls, float width);
    void press(char key);

    float scale_ = 1;
    float height_px_ = 0;                          // As it was shown last.
    std::optional<Workbench::AskedName> asked_ {}; // What `typed_` is a name of.
    std::string typed_ {};
    bool is_selected_ = false; // All of it.
    bool types_capitals_ = true;
    bool confirms_ = false; // By the keyboard, in this frame.
    bool gives_up_ = false; // Likewise.
};

} // namespace tractus::window
