#pragma once

#include <imgui.h>
#include <optional>

namespace tractus {

// What the ring of tools offers, clockwise from the top.
enum class RingChoice { Draw, Select, Lean, Erase, View, Undo, Redo, NextView };

// The tools in a ring that opens at the pointer: one is chosen by pointing at it and touching, or
// by letting the button go over it that opened the ring. A touch in the middle or outside closes
// it.
class ToolRing {
public:
    // Around `place_px`, or as near to it as the whole ring is seen.
    void open(ImVec2 const& place_px, float scale);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }

    // Draws it over everything. `button_let_go`: that which opened it, in this frame.
    std::optional<RingChoice> show(bool button_let_go);

private:
    std::optional<RingChoice> under(ImVec2 const& place_px) const;
    bool take_pointer(bool button_let_go, std::optional<RingChoice>& chosen);
    void draw_sector(RingChoice choice, bool is_pointed_at) const;

    bool is_open_ = false;
    bool was_touched_ = false; // When it opened, and ever since.
    ImVec2 middle_px_ { 0, 0 };
    float scale_ = 1;
};

} // namespace tractus
