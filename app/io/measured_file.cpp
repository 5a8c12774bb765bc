#include "app/io/measured_file.h"

#include "engine/base/file.h"
#include "engine/scene/measured_source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/core.h>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::io {

namespace {

using Format = scene::LoadMeasured::Format;

constexpr std::size_t kMaxMeasuredSize = std::size_t { 64 } << 20;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Returns the first line that is neither blank nor a comment ("#"), without leading white space.
std::string_view first_line(std::string_view text)
{
    while (!text.empty()) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        auto const line = text.substr(0, text.find('\n'));
        if (!line.starts_with('#'))
            return line;
        text.remove_prefix(line.size());
    }
    return {};
}

// Returns the format of a file. The content takes precedence over the extension, as some programs
// save one format with the extension of another.
Format format_of(std::string const& ending, std::string_view text)
{
    auto const line = first_line(text);
    if (line == "ply" || line == "ply\r")
        return Format::Ply;
    if (line.starts_with("CODE"))
        return Format::Mtg;
    return ending == ".mtg" ? Format::Mtg : ending == ".ply" ? Format::Ply : Format::Qsm;
}

// Explains how to convert a file that does not contain a plant yet; empty if no conversion is
// needed.
std::string_view what_is_missing(std::string const& ending, std::filesystem::path const& path)
{
    constexpr std::array<std::string_view, 6> kPoints { ".las", ".laz", ".e57",
                                                        ".pcd", ".pts", ".xyz" };
    if (std::find(kPoints.begin(), kPoints.end(), ending) != kPoints.end())
        return "points of a scanner are no tree yet: let a program such as TreeQSM or AdTree make "
               "cylinders (.csv, .txt) or a skeleton (.ply) of them";
    auto const bytes = ending == ".mat" ? read_file(path, kMaxMeasuredSize) : std::string();
    if (bytes && bytes->starts_with("MATLAB"))
        return "MATLAB's own files are not read: write the tree as text, as TreeQSM's "
               "save_model_text does, and give its file of cylinders";
    return {};
}

} // namespace

Result<std::optional<scene::LoadMeasured>> load_measured_edit(std::filesystem::path const& path)
{
    constexpr std::array<std::string_view, 4> kEndings { ".mtg", ".csv", ".txt", ".ply" };
    auto const ending = lower(path.extension().string());
    if (auto const missing = what_is_missing(ending, path); !missing.empty())
        return fail(Fault::User, fmt::format("{}: {}", path.string(), missing));
    if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end())
        return std::nullopt;
    scene::LoadMeasured edit;
    edit.name = path.string();
    edit.text = TRY(read_text_file(path, kMaxMeasuredSize));
    if (edit.text.starts_with(kByteOrderMark))
        edit.text.erase(0, kByteOrderMark.size());
    edit.format = format_of(ending, edit.text);
    if (ending == ".txt" && lower(edit.text).find("lsystem:") != std::string::npos)
        return std::nullopt;
    TRY(scene::build_measured(edit, {}));
    return edit;
}

} // namespace tractus::io
