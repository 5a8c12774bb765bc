#include "app/window/shortcuts.h"

#include "app/window/input.h"
#include "app/window/tool_choices.h"

#include <algorithm>
#include <array>

namespace tractus {

namespace {

constexpr double kWheelStep_mm = 10;
constexpr double kFineWheelStep_mm = 1; // With Shift.
constexpr double kKeySpeed_mm_s = 80;

// Closes what is open, or else the full screen, or else the window.
void take_escape(Workbench& bench, ToolRing& ring)
{
    bool const is_anything_open = ring.is_open() || bench.menu_is_open() || bench.keys_are_listed;
    ring.close();
    bench.close_menu();
    bench.keys_are_listed = false;
    bool const fills_display = bench.filled_display.has_value();
    if (!is_anything_open && fills_display)
        bench.turn_full_screen();
    bench.wants_to_close = !is_anything_open && !fills_display;
}

void take_tool_keys(WindowModel& model, Workbench& bench)
{
    constexpr std::array<char, 4> kToolKeys { 'D', 'C', 'L', 'E' };
    for (std::size_t i = 0; i < kToolKeys.size(); ++i)
        if (input::is_pressed(kToolKeys[i]))
            bench.choose(model, tool_choices(model.state().erasing)[i].tool);
    if (input::is_pressed('T'))
        bench.choose_view_tool();
}

} // namespace

void take_shortcuts(WindowModel& model, Workbench& bench, ToolRing& ring)
{
    auto const& io = ImGui::GetIO();
    if (input::is_question_mark_typed())
        bench.keys_are_listed = !bench.keys_are_listed;
    if (input::is_escape_pressed())
        take_escape(bench, ring);
    if (input::is_pressed('Q'))
        bench.wants_to_close = true;
    if (io.KeyCtrl) {
        if (input::is_pressed('Z') && model.state().has_session) {
            if (io.KeyShift)
                model.perform(Redo {});
            else
                model.perform(Undo {});
        }
        return;
    }
    if (input::is_pressed('N'))
        model.perform(NextVariation {});
    if (input::is_pressed('V'))
        bench.show_next();
    if (input::is_pressed('F'))
        bench.turn_full_screen();
    if (model.state().is_live)
        take_tool_keys(model, bench);
}

void move_surface_as_wished(WindowModel& model, bool wheel_counts)
{
    if (!model.state().mouse_moves_surface)
        return;
    auto const& io = ImGui::GetIO();
    double by_mm = 0;
    if (wheel_counts)
        by_mm += static_cast<double>(io.MouseWheel)
            * (io.KeyShift ? kFineWheelStep_mm : kWheelStep_mm);
    double const step_s = std::min(0.1, static_cast<double>(io.DeltaTime));
    if (input::is_held('W'))
        by_mm += kKeySpeed_mm_s * step_s;
    if (input::is_held('S'))
        by_mm -= kKeySpeed_mm_s * step_s;
    if (by_mm != 0)
        model.perform(MoveSurface { by_mm });
}

WindowPart show_shortcuts(ImGuiWindowFlags flags, float scale)
{
    struct Key {
        char const* key;
        char const* meaning;
    };
    static constexpr std::array<Key, 13> kKeys {
        { { "D  C  L  E", "draw, select, lean, erase" },
          { "T", "turn and zoom views" },
          { "V", "the next view" },
          { "F", "full screen, or a window again" },
          { "W  S", "surface up, down (without a height sensor)" },
          { "wheel", "the same over the pad; with Shift finely" },
          { "right button", "ring of tools; turns the skeleton" },
          { "Ctrl+Z", "undo" },
          { "Ctrl+Shift+Z", "redo" },
          { "N", "another one: the next seed" },
          { "?", "this list" },
          { "Esc", "closes what is open, full screen, or the window" },
          { "Q", "closes the window" } }
    };
    ImGui::SetNextWindowPos({ 40 * scale, 60 * scale });
    ImGui::Begin("keys", nullptr, flags | ImGuiWindowFlags_AlwaysAutoResize);
    for (auto const& [key, meaning] : kKeys) {
        ImGui::TextUnformatted(key);
        ImGui::SameLine(190 * scale);
        ImGui::TextDisabled("%s", meaning);
    }
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    ImGui::End();
    return { corner.x, corner.y, size.x, size.y };
}

} // namespace tractus
