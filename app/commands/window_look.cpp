#include "app/commands/window_look.h"

#include "app/files/user_folder.h"
#include "calib/toml_table.h"
#include "engine/base/file.h"

#include <array>
#include <fmt/format.h>

namespace tractus::commands {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 2> kColors { "dark", "light" };
constexpr std::array<std::string_view, 2> kHands { "right", "left" };

// True if the value of the key is the second of two words. Fails for any other word than these two.
Result<bool> is_second(calib::TomlTable& table, std::string_view key,
                       std::array<std::string_view, 2> const& words)
{
    if (!table.has(key))
        return false;
    return TRY(table.word(key, { words.begin(), words.end() })) == 1;
}

// Returns the text of the key "least"; empty if the file does not have it.
Result<std::string> least_words(calib::TomlTable& table)
{
    return table.has("least") ? table.text("least") : std::string();
}

} // namespace

fs::path user_look_path()
{
    auto const folder = files::user_folder();
    return folder.empty() ? fs::path() : folder / "window.toml";
}

Result<window::WindowLook> load_look(fs::path const& path)
{
    std::error_code ignored;
    if (path.empty() || !fs::exists(path, ignored))
        return window::WindowLook();
    return parse_look(TRY(read_file(path)), path.string());
}

Result<window::WindowLook> parse_look(std::string_view text, std::string const& name)
{
    auto table = TRY(calib::TomlTable::parse(text, name));
    window::WindowLook look;
    look.is_light = TRY(is_second(table, "colors", kColors));
    look.is_left_handed = TRY(is_second(table, "hand", kHands));
    // Marks the key "least" as known; only load_min_extents() uses its value.
    (void)TRY(least_words(table));
    TRY(table.refuse_unknown_keys());
    return look;
}

Result<tools::MinExtents> load_min_extents(fs::path const& path)
{
    std::error_code ignored;
    if (path.empty() || !fs::exists(path, ignored))
        return tools::MinExtents();
    return parse_look_extents(TRY(read_file(path)), path.string());
}

Result<tools::MinExtents> parse_look_extents(std::string_view text, std::string const& name)
{
    auto table = TRY(calib::TomlTable::parse(text, name));
    auto const words = TRY(least_words(table));
    auto extents = tools::parse_min_extents(words);
    if (!extents)
        return table.wrong("least", fmt::format("is wrong: {}", extents.error().message));
    return extents;
}

std::string print_look(window::WindowLook const& look, tools::MinExtents const& least)
{
    auto const kept = least.empty()
        ? std::string()
        : fmt::format("least = \"{}\"\n", tools::print_min_extents(least));
    return fmt::format("# How tractus' window looks, as chosen there last.\n"
                       "colors = \"{}\"\nhand = \"{}\"\n{}",
                       kColors[look.is_light ? 1 : 0], kHands[look.is_left_handed ? 1 : 0], kept);
}

Result<void> save_look(fs::path const& path, window::WindowLook const& look)
{
    TRY(make_folder(path.parent_path()));
    auto const least = load_min_extents(path).value_or(tools::MinExtents());
    return write_file(path, print_look(look, least));
}

} // namespace tractus::commands
