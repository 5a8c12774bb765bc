#pragma once

#include "app/window/controls.h"
#include "app/window/hand_input.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus::window {

// A panel above the bar for entering the name of the drawing, of a copy of it, or of a card. It has
// on-screen keys for the pen; on a keyboard, Enter confirms and Esc cancels. The old name is
// selected at first, so that typing replaces it, unless the text field is pressed before.
class NamePanel {
public:
    explicit NamePanel(float scale)
        : scale_(scale)
    {
    }

    // Edits `workspace.name_request` in a panel above `bar`, and resets it when the name is
    // confirmed or the panel is closed. `presses` are the keys pressed in this frame. Returns the
    // panel's rectangle.
    WindowPart show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                    WindowPart const& bar, std::span<KeyPress const> presses);

private:
    void show_name(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                   float width);
    void take_keyboard(std::span<KeyPress const> presses);
    void take_letter(unsigned int letter);
    void take_back();
    void show_typed(char const* question, float width);
    void show_keys(Controls const& controls, float width);
    void show_row(std::string_view keys, Controls const& controls, float width);
    void press(char key);

    float scale_ = 1;
    float height_px_ = 0; // Height of the panel in the last frame.
    // The request that the panel is answering, which says what is to be named.
    std::optional<Workspace::NameRequest> asked_ {};
    std::string typed_ {};
    bool is_selected_ = false; // True if all of the text is selected.
    bool types_capitals_ = true;
    bool confirms_ = false; // True if Enter was pressed in this frame.
    bool gives_up_ = false; // True if Esc was pressed in this frame.
};

} // namespace tractus::window
