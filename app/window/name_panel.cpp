#include "app/window/name_panel.h"

#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <imgui_stdlib.h>

namespace tractus {

namespace {

using AskedName = Workbench::AskedName;

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

Words words_of(AskedName::Of of)
{
    switch (of) {
    case AskedName::Of::Drawing:
        return { "What is the drawing called?", "Name it" };
    case AskedName::Of::Copy:
        return { "What is the copy called?", "Copy" };
    case AskedName::Of::Card:
        return { "What is the card called?", "Rename" };
    }
    return {};
}

void perform(WindowModel& model, AskedName const& asked, std::string const& name)
{
    switch (asked.of) {
    case AskedName::Of::Drawing:
        return model.perform(NameDrawing { name });
    case AskedName::Of::Copy:
        return model.perform(SaveCopy { name });
    case AskedName::Of::Card:
        return model.perform(RenameCard { asked.now, name });
    }
}

// Takes the last character away, which may be of several bytes.
void take_last(std::string& text)
{
    auto const is_within = [](char byte) { return (byte & 0xc0) == 0x80; };
    while (!text.empty() && is_within(text.back()))
        text.pop_back();
    if (!text.empty())
        text.pop_back();
}

} // namespace

WindowPart NamePanel::show(WindowModel& model, Workbench& bench, Controls const& controls,
                           WindowPart const& bar)
{
    bool const is_new = asked_ != bench.asked_name;
    if (is_new) {
        asked_ = bench.asked_name;
        typed_ = asked_->now;
        types_capitals_ = typed_.empty();
    }
    float const around = kNameMargin_px * scale_;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, { around, around });
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, { kKeyGap_px * scale_, kKeyGap_px * scale_ });
    // It reaches over the bar rather than out of the window.
    ImGui::SetNextWindowPos({ bar.left, std::max(bar.top - height_px_, 0.0f) });
    ImGui::Begin("name", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    if (is_new)
        ImGui::SetKeyboardFocusHere();
    constexpr float kWidest = kLettersInRow * kWidestKey_px + (kLettersInRow - 1) * kKeyGap_px;
    float const width = std::min((bar.width - 2 * around) / scale_, kWidest);
    show_name(model, bench, controls, width);
    show_keys(controls, width);
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    height_px_ = size.y;
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (!bench.asked_name)
        asked_.reset();
    return { corner.x, corner.y, size.x, size.y };
}

void NamePanel::show_name(WindowModel& model, Workbench& bench, Controls const& controls,
                          float width)
{
    auto const words = words_of(asked_->of);
    theme::push_button_frame(scale_);
    ImGui::SetNextItemWidth((width - 2 * (kNameButton_px + kKeyGap_px)) * scale_);
    bool const is_entered = ImGui::InputTextWithHint("##name", words.question, &typed_,
                                                     ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleVar();
    ImGui::SameLine();
    bool const is_done = controls.button(words.button, kNameButton_px) || is_entered;
    ImGui::SameLine();
    if (controls.button("Close##name", kNameButton_px) || is_done)
        bench.asked_name.reset();
    if (is_done)
        perform(model, *asked_, typed_);
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
        take_last(typed_);
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

// A capital begins a word, and small letters go on.
void NamePanel::press(char key)
{
    typed_ += key;
    types_capitals_ = false;
}

} // namespace tractus
