#pragma once

#include <cstddef>
#include <functional>
#include <imgui.h>
#include <optional>
#include <span>

namespace tractus::window {

// An entry of the ring.
struct RingEntry {
    char const* text = "";
    char const* icon = ""; // Icon in the notation of ToolKind::icon.
    std::function<void()> choose;
};

// A ring of tools that opens at the pointer. A tool is chosen by touching it, or by releasing over
// it the button that opened the ring. A touch in the middle or outside closes it.
class ToolRing {
public:
    // Opens the ring around `place_px`, moved as needed to be fully visible.
    void open(ImVec2 const& place_px, float scale);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }

    // Draws the ring on top of everything, clockwise from the top. Returns the index of the entry
    // chosen in this frame. `button_let_go`: the button that opened the ring was released in this
    // frame.
    std::optional<std::size_t> show(std::span<RingEntry const> entries, bool button_let_go);

private:
    std::optional<std::size_t> under(ImVec2 const& place_px, std::size_t count) const;
    bool take_pointer(bool button_let_go, std::size_t count, std::optional<std::size_t>& chosen);
    void draw_sector(std::span<RingEntry const> entries, std::size_t number,
                     bool is_pointed_at) const;

    bool is_open_ = false;
    // True if the pointer touched in the last frame; also right after the ring opened.
    bool was_touched_ = false;
    ImVec2 middle_px_ { 0, 0 };
    float scale_ = 1;
};

} // namespace tractus::window
