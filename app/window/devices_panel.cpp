#include "app/window/devices_panel.h"

#include "app/devices/watch_view.h"
#include "app/window/theme.h"

#include <fmt/core.h>
#include <string>

namespace tractus::window {

namespace {

std::string hex(drivers::RawReport const& report)
{
    std::string text;
    for (auto const byte : report.bytes())
        text += fmt::format("{}{:02x}", text.empty() ? "" : " ", std::to_integer<unsigned>(byte));
    return text;
}

void show_wrapped(std::string const& text, ImVec4 const& color)
{
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

ImVec4 color_of_trouble()
{
    return theme::imgui_color(theme::palette().indicator);
}

} // namespace

void DevicesPanel::show(view::DevicesView const& view) const
{
    for (auto const& reading : view.readings)
        show_reading(reading);
    ImGui::PushFont(title_font_);
    ImGui::TextUnformatted(view.findings.empty() ? "Nothing is the matter" : "To be mended");
    ImGui::PopFont();
    for (auto const& finding : view.findings)
        show_finding(finding);
}

void DevicesPanel::show_reading(diagnosis::DeviceReading const& reading) const
{
    auto const dim = ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    ImGui::PushFont(title_font_);
    ImGui::TextWrapped("%s", reading.info.name.c_str());
    ImGui::PopFont();
    show_wrapped(fmt::format("{} · {:04x}:{:04x} · {}", reading.info.location,
                             reading.info.vendor_id, reading.info.product_id,
                             reading.description.text),
                 dim);
    show_wrapped(devices::describe_pace(reading), reading.is_away ? color_of_trouble() : dim);
    for (auto const& [name, value] : reading.fields) {
        ImGui::TextDisabled("%s", name.c_str());
        ImGui::SameLine(170 * scale_);
        ImGui::TextUnformatted(value.c_str());
    }
    if (reading.last)
        show_wrapped(hex(*reading.last), dim);
    if (!reading.first_broken.empty())
        show_wrapped("broken: " + reading.first_broken, color_of_trouble());
    for (auto const& fault : reading.height_faults)
        show_wrapped(fault, color_of_trouble());
    ImGui::Dummy({ 1, ImGui::GetFontSize() * 0.5f });
}

void DevicesPanel::show_finding(diagnosis::Finding const& finding)
{
    show_wrapped(finding.subject, color_of_trouble());
    ImGui::TextWrapped("%s", finding.what.c_str());
    for (auto const& line : finding.remedy)
        show_wrapped(line, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::Dummy({ 1, ImGui::GetFontSize() * 0.3f });
}

} // namespace tractus::window
