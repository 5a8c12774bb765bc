#include "app/window/start_view.h"

#include "app/window/icon.h"
#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace tractus::window {

namespace {

constexpr float kCardAir_px = 10; // Space between a card's edge and its text.
constexpr float kBorder_px = 5;   // Width of the border around a card's picture.
constexpr float kDetailSize_px = 16;
constexpr float kMinSize_px = 15;  // Minimum text size to which text is shrunk to fit.
constexpr float kIconSize = 0.62f; // Size of an icon, as a share of the height of a card's picture.
constexpr float kIconLine_px = 3;
// A touch that moves farther than this scrolls the page, and does not choose a card.
constexpr float kScrollFrom_px = 8;

std::optional<Direction> direction_of(char key)
{
    switch (key) {
    case KeyPress::kLeft:
        return Direction::Left;
    case KeyPress::kRight:
        return Direction::Right;
    case KeyPress::kUp:
        return Direction::Up;
    case KeyPress::kDown:
        return Direction::Down;
    default:
        return std::nullopt;
    }
}

float width_of(std::string const& text, float size_px)
{
    return ImGui::GetFont()->CalcTextSizeA(size_px, 1e6f, 0, text.c_str()).x;
}

// Returns the index of the first byte of the last character in a UTF-8 text.
std::size_t beginning_of_last_letter(std::string const& text)
{
    auto at = text.size() - 1;
    while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80)
        --at;
    return at;
}

// Splits text in two: as many words as fit on the first line, and the rest.
std::pair<std::string, std::string> in_two_lines(std::string const& text, float size_px,
                                                 float room_px)
{
    if (width_of(text, size_px) <= room_px)
        return { text, {} };
    std::size_t end = 0; // Index at which the first line ends.
    for (auto space = text.find(' '); space != std::string::npos; space = text.find(' ', space + 1))
        if (width_of(text.substr(0, space), size_px) <= room_px)
            end = space;
    if (end == 0)
        return { text, {} };
    return { text.substr(0, end), text.substr(end + 1) };
}

} // namespace

void StartView::show(view::StartPageModel& page, Workspace& workspace, Controls const& controls)
{
    show_head(page, workspace, controls);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_WindowBg));
    bool const has_study = page.state().study.has_value();
    ImGui::BeginChild(has_study ? "study" : "cards", { 0, 0 }, false,
                      ImGuiWindowFlags_NoSavedSettings);
    if (has_study)
        study_.show(page, controls);
    else
        show_cards(page);
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void StartView::show_head(view::StartPageModel& page, Workspace& workspace,
                          Controls const& controls) const
{
    auto const& state = page.state();
    constexpr std::array kWidths_px { 96.0f, 150.0f, 96.0f };
    constexpr float kTourButton_px = 120;
    float const gap = ImGui::GetStyle().ItemSpacing.x;
    float const room = ImGui::GetContentRegionAvail().x;
    float const tour = state.offers_tour ? kTourButton_px * scale_ + gap : 0;
    float const buttons = (kWidths_px[0] + kWidths_px[1] + kWidths_px[2]) * scale_ + 2 * gap + tour;
    auto const place = ImGui::GetCursorPos();
    auto const fits = [&](ImFont const* font, char const* text) {
        return font->CalcTextSizeA(font->FontSize, 1e6f, 0, text).x + gap < room - buttons;
    };
    bool const has_note_below = !state.note.empty() && !fits(ImGui::GetFont(), state.note.c_str());
    bool const has_note = !state.note.empty() && !has_note_below;
    ImGui::PushFont(has_note ? ImGui::GetFont() : title_font_);
    char const* const title = has_note           ? state.note.c_str()
        : fits(title_font_, state.title.c_str()) ? state.title.c_str()
                                                 : "Tractus";
    ImGui::SetCursorPosY(place.y + (theme::kButtonHeight_px * scale_ - ImGui::GetFontSize()) / 2);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    ImGui::SetCursorPos({ place.x + std::max(0.0f, room - buttons), place.y });
    bool const begins_tour = state.offers_tour && controls.button("Take a tour", kTourButton_px);
    if (state.offers_tour)
        ImGui::SameLine();
    if (controls.button(theme::palette().is_light ? "Dark" : "Light", kWidths_px[0]))
        theme::set_light(!theme::palette().is_light);
    ImGui::SameLine();
    if (controls.button("Full screen", kWidths_px[1], workspace.will_fill_display()))
        workspace.turn_full_screen();
    ImGui::SameLine();
    bool const goes_back = state.is_beside_drawing && controls.button("Back", kWidths_px[2]);
    if (!state.is_beside_drawing && controls.button("Close", kWidths_px[2]))
        workspace.is_close_requested = true;
    if (has_note_below)
        ImGui::TextWrapped("%s", state.note.c_str());
    ImGui::Dummy({ 1, 2 * scale_ });
    if (goes_back)
        page.leave();
    if (begins_tour)
        page.begin_tour();
}

void StartView::show_cards(view::StartPageModel& page)
{
    auto const& state = page.state();
    auto const origin = ImGui::GetCursorPos();
    float const width = ImGui::GetWindowWidth();
    float const height = ImGui::GetWindowHeight();
    grid_ = arrange_cards(state.groups, width, scale_);
    // If the page needs a scroll bar, its cards are arranged again in less width.
    if (grid_.height > height)
        grid_ = arrange_cards(
            state.groups, width - ImGui::GetStyle().ScrollbarSize - kCardAir_px * scale_, scale_);
    ImGui::PushFont(title_font_);
    for (auto const& title : grid_.titles) {
        ImGui::SetCursorPos({ origin.x + title.left, origin.y + title.top + 4 * scale_ });
        ImGui::TextUnformatted(title.text.c_str());
    }
    ImGui::PopFont();
    std::optional<std::size_t> pressed;
    ImGui::BeginDisabled(state.is_opening);
    for (std::size_t i = 0; i < grid_.places.size(); ++i) {
        auto const& place = grid_.places[i];
        ImGui::SetCursorPos({ origin.x + place.left, origin.y + place.top });
        ImGui::PushID(static_cast<int>(i));
        if (show_card(state.groups[place.group].cards[place.card],
                      { grid_.card_width, grid_.card_height }, focus_ == i))
            pressed = i;
        ImGui::PopID();
    }
    ImGui::EndDisabled();
    ImGui::SetCursorPos({ origin.x, origin.y + grid_.height });
    ImGui::Dummy({ 1, ImGui::GetStyle().ItemSpacing.y });
    if (std::exchange(focus_has_moved_, false))
        scroll_to_focus();
    bool presses_count = true;
    scroll(presses_count);
    if (pressed && presses_count)
        page.choose(grid_.places[*pressed].group, grid_.places[*pressed].card);
}

// Scrolls the page when it is dragged. A touch that scrolls does not choose a card: it clears
// `presses_count`.
void StartView::scroll(bool& presses_count)
{
    bool const drags = ImGui::GetScrollMaxY() > 0
        && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kScrollFrom_px * scale_);
    if (drags && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
        scrolls_ = true;
    presses_count = !scrolls_;
    if (scrolls_ && drags)
        ImGui::SetScrollY(ImGui::GetScrollY() - ImGui::GetIO().MouseDelta.y);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left))
        scrolls_ = false;
}

void StartView::scroll_to_focus() const
{
    if (!focus_ || *focus_ >= grid_.places.size())
        return;
    float const air = ImGui::GetStyle().ItemSpacing.y;
    auto const top = grid_.places[*focus_].top;
    auto const bottom = top + grid_.card_height + 2 * air;
    // Scrolls far enough to show also the title above the card's row.
    float const first = top - 48 * scale_;
    if (first < ImGui::GetScrollY())
        ImGui::SetScrollY(std::max(0.0f, first));
    else if (bottom > ImGui::GetScrollY() + ImGui::GetWindowHeight())
        ImGui::SetScrollY(bottom - ImGui::GetWindowHeight());
}

bool StartView::show_card(view::StartCard const& card, ImVec2 const& size_px, bool has_focus)
{
    auto const corner = ImGui::GetCursorScreenPos();
    bool const is_pressed = ImGui::Button("##card", size_px);
    bool const is_marked = has_focus || ImGui::IsItemHovered();
    if (!ImGui::IsItemVisible())
        return is_pressed;
    draw_picture(card, corner);
    draw_words(card, corner);
    if (is_marked)
        ImGui::GetWindowDrawList()->AddRect(corner, { corner.x + size_px.x, corner.y + size_px.y },
                                            theme::packed(theme::palette().selected),
                                            ImGui::GetStyle().FrameRounding, 0, 3 * scale_);
    return is_pressed;
}

// Draws the picture of a card. If the picture is too high it is cropped, more at the bottom than at
// the top.
void StartView::draw_picture(view::StartCard const& card, ImVec2 const& corner)
{
    auto* const draw = ImGui::GetWindowDrawList();
    float const border = kBorder_px * scale_;
    ImVec2 const from(corner.x + border, corner.y + border);
    ImVec2 const to(corner.x + grid_.card_width - border, corner.y + grid_.picture_height);
    float const rounding = std::max(0.0f, ImGui::GetStyle().FrameRounding - border / 2);
    if (!card.picture || card.picture->width() == 0) {
        draw->AddRectFilled(from, to, theme::packed(theme::palette().pad_background), rounding);
        float const size = kIconSize * (to.y - from.y);
        draw_icon(card.icon.c_str(), { (from.x + to.x) / 2, (from.y + to.y + size) / 2 }, size,
                  kIconLine_px * scale_);
        return;
    }
    auto const width = static_cast<float>(card.picture->width());
    auto const height = static_cast<float>(card.picture->height());
    float const shown = std::min(1.0f, width * (to.y - from.y) / ((to.x - from.x) * height));
    float const sky = (1 - shown) / 4;
    auto const texture = static_cast<std::uintptr_t>(texture_of(card.picture));
    draw->AddImageRounded(reinterpret_cast<ImTextureID>(texture), from, to, { 0, sky },
                          { 1, sky + shown }, ImGui::GetColorU32({ 1, 1, 1, 1 }), rounding);
}

void StartView::draw_words(view::StartCard const& card, ImVec2 const& corner) const
{
    float const left = corner.x + kCardAir_px * scale_;
    float const top = corner.y + grid_.picture_height + 4 * scale_;
    draw_fitted(card.title, { left, top }, ImGui::GetFontSize(), ImGui::GetColorU32(ImGuiCol_Text));
    auto const gray = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    float const size = kDetailSize_px * scale_;
    float const below = top + ImGui::GetFontSize() + 3 * scale_;
    auto const [line, rest] = in_two_lines(card.detail, size, words_width());
    draw_fitted(line, { left, below }, size, gray);
    draw_fitted(rest, { left, below + size + scale_ }, size, gray);
}

float StartView::words_width() const
{
    return grid_.card_width - 2 * kCardAir_px * scale_;
}

// Draws text in a smaller size if it does not fit otherwise. If it does not fit in the smallest
// size, it ends in an ellipsis.
void StartView::draw_fitted(std::string const& text, ImVec2 const& place, float size_px,
                            ImU32 color) const
{
    float const room = words_width();
    float const usual = width_of(text, size_px);
    float const least = std::min(size_px, kMinSize_px * scale_);
    float const size = usual <= room ? size_px : std::max(least, size_px * room / usual);
    auto shown = text;
    if (width_of(text, size) > room + 1) {
        while (shown.size() > 1 && width_of(shown + "...", size) > room)
            shown.resize(beginning_of_last_letter(shown));
        shown += "...";
    }
    // Aligns the baseline of smaller text with that of normal text.
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size,
                                        { place.x, place.y + (size_px - size) * 0.8f }, color,
                                        shown.c_str());
}

GLuint StartView::texture_of(std::shared_ptr<render::Image const> const& picture)
{
    auto found = textures_.find(picture.get());
    if (found == textures_.end())
        found = textures_.emplace(picture.get(), Texture { picture, render::GpuPicture(*picture) })
                    .first;
    return found->second.on_card.texture();
}

void StartView::take_key(KeyPress const& press, view::StartPageModel& page, Workspace& workspace)
{
    static std::vector<view::StartCards> const no_cards;
    bool const has_study = page.state().study.has_value();
    auto const& groups = has_study ? no_cards : page.state().groups;
    if (has_study && press.key == KeyPress::kEnter)
        return page.accept();
    if (auto const direction = direction_of(press.key)) {
        if (!grid_.places.empty() && !has_study)
            focus_ = focus_ ? neighbour(grid_, *focus_, *direction) : 0;
        focus_has_moved_ = true;
        return;
    }
    if (press.key == KeyPress::kEnter) {
        if (focus_ && *focus_ < grid_.places.size())
            page.choose(grid_.places[*focus_].group, grid_.places[*focus_].card);
        return;
    }
    for (std::size_t group = 0; group < groups.size(); ++group)
        for (std::size_t card = 0; card < groups[group].cards.size(); ++card)
            if (groups[group].cards[card].key == press.key && !press.has_control)
                return page.choose(group, card);
    if (press.key == 'F' && !press.has_control)
        workspace.turn_full_screen();
    else if (press.key == KeyPress::kEscape && workspace.will_fill_display())
        workspace.turn_full_screen();
    else if (press.key == KeyPress::kEscape && page.state().is_beside_drawing)
        page.leave();
    else if (press.key == KeyPress::kEscape || press.key == 'Q')
        workspace.is_close_requested = true;
}

void StartView::leave()
{
    textures_.clear();
    study_.leave();
    focus_.reset();
}

} // namespace tractus::window
