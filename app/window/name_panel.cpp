#include "app/window/name_panel.h"

#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <imgui.h>
#include <utility>

namespace tractus::window {

namespace {

using NameRequest = Workspace::NameRequest;

constexpr float kNameMargin_px = 14;
constexpr float kWidestKey_px = 64;
constexpr float kNameButton_px = 116;
constexpr float kKeyGap_px = 6;
constexpr std::size_t kLettersInRow = 10;
constexpr std::array<std::string_view, 4> kLetterRows { "1234567890", "QWERTYUIOP", "ASDFGHJKL-",
                                                        "ZXCVBNM,.'" };

struct Words {
    char const* question;
    char const* button;
};

Words words_of(NameRequest::Of of)
{
    switch (of) {
    case NameRequest::Of::Drawing:
        return { "What is the drawing called?", "Name it" };
    case NameRequest::Of::Copy:
        return { "What is the copy called?", "Copy" };
    case NameRequest::Of::Card:
        return { "What is the card called?", "Rename" };
    }
    return {};
}

void perform(view::WindowModel& model, NameRequest const& asked, std::string const& name)
{
    switch (asked.of) {
    case NameRequest::Of::Drawing:
        return model.perform(view::NameDrawing { name });
    case NameRequest::Of::Copy:
        return model.perform(view::SaveCopy { name });
    case NameRequest::Of::Card:
        return model.perform(view::RenameCard { asked.now, name });
    }
}

// Removes the last character of a UTF-8 text.
void take_last(std::string& text)
{
    auto const is_within = [](char byte) { return (byte & 0xc0) == 0x80; };
    while (!text.empty() && is_within(text.back()))
        text.pop_back();
    if (!text.empty())
        text.pop_back();
}

// Appends a code point in UTF-8 (RFC 3629, section 3).
void append_letter(std::string& text, unsigned int letter)
{
    constexpr unsigned int kSix = 0x3f;
    if (letter < 0x20 || letter == 0x7f)
        return;
    auto const add = [&](unsigned int byte) { text += static_cast<char>(byte); };
    if (letter < 0x80) {
        add(letter);
    } else if (letter < 0x800) {
        add(0xc0 | letter >> 6);
        add(0x80 | (letter & kSix));
    } else {
        add(0xe0 | letter >> 12);
        add(0x80 | (letter >> 6 & kSix));
        add(0x80 | (letter & kSix));
    }
}

// Draws the text of ImGui's last item as selected. The text begins at the item's left edge.
void mark_selected(std::string const& text)
{
    auto const& padding = ImGui::GetStyle().FramePadding;
    auto const top = ImGui::GetItemRectMin();
    auto const bottom = ImGui::GetItemRectMax();
    float const left = top.x + padding.x;
    float const right = std::min(left + ImGui::CalcTextSize(text.c_str()).x, bottom.x - padding.x);
    ImGui::GetWindowDrawList()->AddRectFilled({ left, top.y + padding.y },
                                              { right, bottom.y - padding.y },
                                              ImGui::GetColorU32(ImGuiCol_TextSelectedBg));
}

} // namespace

WindowPart NamePanel::show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                           WindowPart const& bar, std::span<KeyPress const> presses)
{
    bool const is_new = asked_ != workspace.name_request;
    if (is_new) {
        asked_ = workspace.name_request;
        typed_ = asked_->now;
        is_selected_ = !typed_.empty();
        types_capitals_ = true;
    }
    take_keyboard(presses);
    float const around = kNameMargin_px * scale_;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, { around, around });
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, { kKeyGap_px * scale_, kKeyGap_px * scale_ });
    // If there is too little room above the bar, the panel overlaps the bar instead of leaving the
    // window.
    ImGui::SetNextWindowPos({ bar.left, std::max(bar.top - height_px_, 0.0f) });
    ImGui::Begin("name", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    constexpr float kWidest = kLettersInRow * kWidestKey_px + (kLettersInRow - 1) * kKeyGap_px;
    float const width = std::min((bar.width - 2 * around) / scale_, kWidest);
    show_name(model, workspace, controls, width);
    show_keys(controls, width);
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    height_px_ = size.y;
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (!workspace.name_request)
        asked_.reset();
    return { corner.x, corner.y, size.x, size.y };
}

void NamePanel::show_name(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                          float width)
{
    auto const words = words_of(asked_->of);
    show_typed(words.question, width - 2 * (kNameButton_px + kKeyGap_px));
    ImGui::SameLine();
    bool const is_done = controls.button(words.button, kNameButton_px) || confirms_;
    ImGui::SameLine();
    if (controls.button("Close##name", kNameButton_px) || is_done || gives_up_)
        workspace.name_request.reset();
    if (is_done)
        perform(model, *asked_, typed_);
}

// Reads key presses without a text field of ImGui, so that on-screen keys and the keyboard can be
// mixed.
void NamePanel::take_keyboard(std::span<KeyPress const> presses)
{
    confirms_ = false;
    gives_up_ = false;
    for (auto const letter : ImGui::GetIO().InputQueueCharacters)
        take_letter(letter);
    for (auto const& press : presses) {
        confirms_ |= press.key == KeyPress::kEnter;
        gives_up_ |= press.key == KeyPress::kEscape;
        if (press.key == KeyPress::kBackspace)
            take_back();
    }
}

void NamePanel::take_letter(unsigned int letter)
{
    if (std::exchange(is_selected_, false))
        typed_.clear();
    append_letter(typed_, letter);
}

void NamePanel::take_back()
{
    if (std::exchange(is_selected_, false))
        typed_.clear();
    else
        take_last(typed_);
}

void NamePanel::show_typed(char const* question, float width)
{
    auto const& field = ImGui::GetStyleColorVec4(ImGuiCol_FrameBg);
    for (auto const color : { ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive })
        ImGui::PushStyleColor(color, field);
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, { 0, 0.5f });
    auto const shown = typed_.empty() ? std::string(question)
        : is_selected_                ? typed_
                                      : typed_ + "|";
    ImGui::BeginDisabled(typed_.empty());
    if (ImGui::Button((shown + "###typed").c_str(),
                      { width * scale_, theme::kButtonHeight_px * scale_ }))
        is_selected_ = false;
    ImGui::EndDisabled();
    if (is_selected_)
        mark_selected(typed_);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(3);
}

void NamePanel::show_keys(Controls const& controls, float width)
{
    for (auto const row : kLetterRows)
        show_row(row, controls, width);
    if (controls.button("Shift", kNameButton_px, types_capitals_))
        types_capitals_ = !types_capitals_;
    ImGui::SameLine();
    if (controls.button("Space", width - 2 * (kNameButton_px + kKeyGap_px)))
        press(' ');
    ImGui::SameLine();
    ImGui::PushButtonRepeat(true);
    if (controls.button("Delete", kNameButton_px))
        take_back();
    ImGui::PopButtonRepeat();
}

void NamePanel::show_row(std::string_view keys, Controls const& controls, float width)
{
    auto const gaps = static_cast<float>(kLettersInRow - 1) * kKeyGap_px;
    float const key_px = (width - gaps) / static_cast<float>(kLettersInRow);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (i > 0)
            ImGui::SameLine();
        auto const letter = static_cast<unsigned char>(keys[i]);
        auto const key = static_cast<char>(types_capitals_ ? letter : std::tolower(letter));
        if (controls.button(std::string(1, key).c_str(), key_px))
            press(key);
    }
}

// Enters the letter of an on-screen key. The letters after it are small ones.
void NamePanel::press(char key)
{
    take_letter(static_cast<unsigned char>(key));
    types_capitals_ = false;
}

} // namespace tractus::window
