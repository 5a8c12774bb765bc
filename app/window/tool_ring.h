#pragma once

#include <cstddef>
#include <functional>
#include <imgui.h>
#include <optional>
#include <span>

namespace tractus::window {

// Something that the ring offers.
struct RingEntry {
    char const* text = "";
    char const* icon = ""; // See ToolKind::icon.
    std::function<void()> choose;
};

// The tools in a ring that opens at the pointer: one is chosen by pointing at it and touching, or
// by letting the button go over it that opened the ring. A touch in the middle or outside closes
// it.
class ToolRing {
public:
    // Around `place_px`, or as near to it as the whole ring is seen.
    void open(ImVec2 const& place_px, float scale);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }

    // Draws it over everything, the first entry at the top, the others clockwise. The number of the
    // one that is chosen. `button_let_go`: that which opened it, in this frame.
    std::optional<std::size_t> show(std::span<RingEntry const> entries, bool button_let_go);

private:
    std::optional<std::size_t> under(ImVec2 const& place_px, std::size_t count) const;
    bool take_pointer(bool button_let_go, std::size_t count, std::optional<std::size_t>& chosen);
    void draw_sector(std::span<RingEntry const> entries, std::size_t number,
                     bool is_pointed_at) const;

    bool is_open_ = false;
    bool was_touched_ = false; // When it opened, and ever since.
    ImVec2 middle_px_ { 0, 0 };
    float scale_ = 1;
};

} // namespace tractus::window
