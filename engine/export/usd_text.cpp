#include "engine/export/usd_text.h"

namespace tractus::exports {

std::string usd_name(std::string const& name)
{
    auto const is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::string word;
    if (name.empty() || is_digit(name[0]))
        word = "_";
    for (char const c : name) {
        bool const is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        word += is_letter || is_digit(c) ? c : '_';
    }
    return word;
}

std::string UsdNames::unused(std::string const& wanted)
{
    auto const word = usd_name(wanted);
    auto name = word;
    for (int number = 2; !used_.insert(name).second; ++number)
        name = fmt::format("{}_{}", word, number);
    return name;
}

UsdText::UsdText(std::ostream& out, std::string_view default_prim)
    : out_(out)
{
    fmt::format_to(std::back_inserter(text_),
                   "#usda 1.0\n(\n"
                   "    defaultPrim = \"{}\"\n"
                   "    doc = \"tractus\"\n"
                   "    metersPerUnit = 1\n"
                   "    upAxis = \"Y\"\n"
                   ")\n",
                   default_prim);
}

void UsdText::begin(std::string_view type, std::string_view name,
                    std::span<std::string const> metadata)
{
    append("\n");
    indent();
    fmt::format_to(std::back_inserter(text_), "def {} \"{}\"", type, name);
    if (!metadata.empty()) {
        append(" (\n");
        open_.emplace_back(name);
        for (auto const& entry : metadata)
            line("{}", entry);
        open_.pop_back();
        indent();
        append(")");
    }
    append("\n");
    line("{{");
    open_.emplace_back(name);
}

void UsdText::end()
{
    open_.pop_back();
    line("}}");
}

std::string UsdText::path() const
{
    std::string path;
    for (auto const& name : open_)
        path += "/" + name;
    return path;
}

void UsdText::flush()
{
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
}

void UsdText::indent()
{
    for (std::size_t i = 0; i < open_.size(); ++i)
        append("    ");
}

void UsdText::end_line()
{
    append("\n");
}

void UsdText::end_array(std::string_view interpolation)
{
    if (!interpolation.empty()) {
        append(" (\n");
        indent();
        fmt::format_to(std::back_inserter(text_), "    interpolation = \"{}\"\n", interpolation);
        indent();
        append(")");
    }
    end_line();
}

} // namespace tractus::exports
