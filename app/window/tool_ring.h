#pragma once

#include <cstddef>
#include <functional>
#include <imgui.h>
#include <optional>
#include <span>

namespace tractus::window {

// An entry of the tool ring.
struct RingEntry {
    char const* text = "";
    char const* icon = ""; // Icon in the notation of ToolKind::icon.
    std::function<void()> choose;
};

// A ring of tools that opens around the pointer. A tool is chosen by touching its entry, or by
// releasing the button that opened the ring over the entry. A touch in the middle of the ring or
// outside it closes the ring.
class ToolRing {
public:
    // Opens the ring around `place_px`, but moved so far that all of it is visible.
    void open(ImVec2 const& place_px, float scale);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }

    // Draws the ring on top of everything. The entries are placed clockwise, beginning at the top.
    // Returns the index of the entry that was chosen in this frame. `button_let_go` is true if the
    // button that opened the ring was released in this frame.
    std::optional<std::size_t> show(std::span<RingEntry const> entries, bool button_let_go);

private:
    std::optional<std::size_t> under(ImVec2 const& place_px, std::size_t count) const;
    bool take_pointer(bool button_let_go, std::size_t count, std::optional<std::size_t>& chosen);
    void draw_sector(std::span<RingEntry const> entries, std::size_t number,
                     bool is_pointed_at) const;

    bool is_open_ = false;
    // True if the pointer was touching in the last frame, and also directly after the ring was
    // opened.
    bool was_touched_ = false;
    ImVec2 middle_px_ { 0, 0 };
    float scale_ = 1;
};

} // namespace tractus::window
