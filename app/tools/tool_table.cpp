#include "app/tools/tool_table.h"

#include <fmt/format.h>
#include <utility>
#include <vector>

namespace tractus::tools {

namespace {

// Lists the values that each option can have: for a word option, all words except the default; for
// a number option, its name and range. Options that users never choose are left out.
class OptionLister final : public OptionVisitor {
public:
    void word(WordOption const& option, int&) override
    {
        if (option.offered == WordOption::Offered::Never)
            return;
        auto& words = options.emplace_back();
        for (std::size_t i = 1; i < option.words.size(); ++i)
            words.emplace_back(option.words[i].word);
    }

    void number(NumberOption const& option, double&) override
    {
        options.push_back({ fmt::format("{}={:g}..{:g}{}{}", option.name, option.least,
                                        option.greatest, *option.unit ? " " : "", option.unit) });
    }

    std::vector<std::vector<std::string>> options;
};

std::vector<std::vector<std::string>> options_of(ToolKind const& kind)
{
    OptionLister lister;
    Tool(kind).show(lister);
    return std::move(lister.options);
}

std::string words_in_manual(ToolKind const& kind)
{
    std::string list;
    for (auto const& words : options_of(kind))
        list += fmt::format("{}`{}`", list.empty() ? "" : "; ", fmt::join(words, "`, `"));
    return list;
}

} // namespace

std::string describe_tool(ToolKind const& kind)
{
    std::string text = kind.word;
    for (auto const& words : options_of(kind))
        text += fmt::format(" [{}]", fmt::join(words, "|"));
    if (kind.key)
        text += fmt::format("  (key {})", kind.key);
    auto const least = kind.min_extent_mm > 0
        ? fmt::format(" (strokes from {:g} mm on)", kind.min_extent_mm)
        : std::string();
    return fmt::format("{}\n    {}{}\n", text, kind.help, least);
}

std::string manual_table(ToolKinds kinds)
{
    std::string table = "| tool | words | key | from | what it does |\n"
                        "| --- | --- | --- | --- | --- |\n";
    for (auto const* const kind : kinds) {
        auto const key = kind->key ? fmt::format("**{}**", kind->key) : std::string();
        auto const least
            = kind->min_extent_mm > 0 ? fmt::format("{:g} mm", kind->min_extent_mm) : std::string();
        table += fmt::format("| `{}` | {} | {} | {} | {} |\n", kind->word, words_in_manual(*kind),
                             key, least, kind->help);
    }
    return table;
}

} // namespace tractus::tools
