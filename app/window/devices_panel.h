#pragma once

#include "app/view/window_model.h"

#include <imgui.h>

namespace tractus::window {

// The devices that are read, live: what each is, how regularly it sends, its newest bytes and what
// they mean; and what is the matter with them or with the machine, and what to do about it. Draws
// itself into the current ImGui window's room.
class DevicesPanel {
public:
    // `title_font` is theme::apply()'s; `scale` the display's.
    DevicesPanel(ImFont* title_font, float scale)
        : title_font_(title_font)
        , scale_(scale)
    {
    }

    void show(view::DevicesView const& view) const;

private:
    void show_reading(diagnosis::DeviceReading const& reading) const;
    static void show_finding(diagnosis::Finding const& finding);

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
};

} // namespace tractus::window
