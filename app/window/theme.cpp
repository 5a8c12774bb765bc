#include "app/window/theme.h"

#include "app/render/font.h"

namespace tractus::window::theme {

namespace {

ImFont* add_font(float size_px)
{
    static constexpr ImWchar kRanges[] { 0x20,   0xff,   0x2010, 0x2030, 0x2190,
                                         0x21ff, 0x25a0, 0x25ff, 0 };
    auto const file = render::font_file();
    ImFontConfig config;
    // Stops ImGui from freeing the font's data, which belongs to the program.
    config.FontDataOwnedByAtlas = false;
    auto* const bytes = const_cast<std::byte*>(file.data());
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(bytes, static_cast<int>(file.size()), size_px,
                                                      &config, kRanges);
}

// Returns a slightly bluish grey for dark rooms; warm() returns a slightly warm one for bright
// rooms.
ImVec4 cool(float value)
{
    return { value, value * 1.04f, value * 1.09f, 1 };
}

ImVec4 warm(float value)
{
    return { value, value * 0.997f, value * 0.985f, 1 };
}

void set_dark_colors(ImGuiStyle& style)
{
    ImGui::StyleColorsDark(&style);
    style.Colors[ImGuiCol_WindowBg] = cool(0.135f);
    style.Colors[ImGuiCol_ChildBg] = cool(0.10f);
    style.Colors[ImGuiCol_Text] = cool(0.91f);
    style.Colors[ImGuiCol_TextDisabled] = cool(0.60f);
    style.Colors[ImGuiCol_Border] = cool(0.22f);
    style.Colors[ImGuiCol_Button] = cool(0.23f);
    style.Colors[ImGuiCol_ButtonHovered] = cool(0.31f);
    style.Colors[ImGuiCol_ButtonActive] = cool(0.40f);
    style.Colors[ImGuiCol_FrameBg] = cool(0.20f);
    style.Colors[ImGuiCol_FrameBgHovered] = cool(0.25f);
    style.Colors[ImGuiCol_FrameBgActive] = cool(0.29f);
    style.Colors[ImGuiCol_CheckMark] = { 0.13f, 0.42f, 0.62f, 1 };
}

void set_light_colors(ImGuiStyle& style)
{
    ImGui::StyleColorsLight(&style);
    style.Colors[ImGuiCol_WindowBg] = warm(0.90f);
    style.Colors[ImGuiCol_ChildBg] = warm(0.94f);
    style.Colors[ImGuiCol_Text] = warm(0.08f);
    style.Colors[ImGuiCol_TextDisabled] = warm(0.38f);
    style.Colors[ImGuiCol_Border] = warm(0.75f);
    style.Colors[ImGuiCol_Button] = warm(0.80f);
    style.Colors[ImGuiCol_ButtonHovered] = warm(0.73f);
    style.Colors[ImGuiCol_ButtonActive] = warm(0.66f);
    style.Colors[ImGuiCol_FrameBg] = warm(0.82f);
    style.Colors[ImGuiCol_FrameBgHovered] = warm(0.78f);
    style.Colors[ImGuiCol_FrameBgActive] = warm(0.74f);
    style.Colors[ImGuiCol_CheckMark] = { 0.50f, 0.76f, 0.93f, 1 };
}

} // namespace

void set_light(bool is_light)
{
    use_light_palette(is_light);
    auto& style = ImGui::GetStyle();
    if (is_light)
        set_light_colors(style);
    else
        set_dark_colors(style);
    style.Colors[ImGuiCol_SliderGrab] = imgui_color(palette().selected);
    style.Colors[ImGuiCol_SliderGrabActive] = imgui_color(palette().selected);
    style.Colors[ImGuiCol_PlotHistogram] = imgui_color(palette().selected);
}

void push_button_frame(float scale)
{
    float const air_px = (kButtonHeight_px * scale - ImGui::GetFontSize()) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, { 16 * scale, air_px });
}

void scroll_by_dragging()
{
    bool const drags
        = ImGui::IsMouseDragging(ImGuiMouseButton_Left, 4) && !ImGui::IsAnyItemHovered();
    if (drags && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
        ImGui::SetScrollY(ImGui::GetScrollY() - ImGui::GetIO().MouseDelta.y);
}

ImFont* apply(float scale)
{
    auto& style = ImGui::GetStyle();
    set_light(palette().is_light);
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.ChildRounding = 8;
    style.FrameRounding = 8;
    style.GrabRounding = 8;
    style.WindowPadding = { 16, 14 };
    style.FramePadding = { 16, 10 };
    style.ItemSpacing = { 12, 10 };
    style.GrabMinSize = 28;
    style.ScrollbarSize = 22;
    style.ScaleAllSizes(scale);
    add_font(kTextSize_px * scale);
    return add_font(kTitleSize_px * scale);
}

} // namespace tractus::window::theme
