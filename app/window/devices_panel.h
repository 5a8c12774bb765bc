#pragma once

#include "app/view/window_model.h"

#include <imgui.h>

namespace tractus::window {

// Live information about the connected devices: what each is, how regularly it reports, and its
// newest bytes with their meaning. Also shows problems of the devices or the machine, with their
// remedies. Draws into the current ImGui window.
class DevicesPanel {
public:
    // `title_font` comes from theme::apply(); `scale` is the display's scale factor.
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
