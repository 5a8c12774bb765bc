#include "app/controllers/card_library.h"

#include "engine/base/file.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <ostream>
#include <string_view>
#include <system_error>

namespace tractus::controllers {

namespace fs = std::filesystem;

static constexpr char const* kEnding = ".card";

fs::path CardLibrary::file_of(std::string const& name) const
{
    return folder_ / (name + kEnding);
}

std::vector<tools::ToolCard> CardLibrary::cards_of(tools::ToolKinds kinds,
                                                   tools::ToolKind const& kind) const
{
    constexpr std::size_t kMaxBytes = 4096;
    std::vector<fs::path> files;
    std::error_code error; // Errors are ignored: a missing folder contains no cards.
    for (fs::directory_iterator file(folder_, error), end; !error && file != end;
         file.increment(error))
        if (file->path().extension() == kEnding && files.size() < kMaxCards)
            files.push_back(file->path());
    std::sort(files.begin(), files.end());
    std::vector<tools::ToolCard> cards;
    for (auto const& file : files) {
        auto const text = read_text_file(file, kMaxBytes);
        auto tool
            = text ? tools::parse_card(kinds, *text, file.string()) : tl::unexpected(text.error());
        if (tool && &tool->kind() == &kind)
            cards.push_back({ file.stem().string(), *std::move(tool) });
    }
    return cards;
}

Result<std::string> CardLibrary::keep(tools::Tool const& hand) const
{
    if (folder_.empty())
        return fail(Fault::User, "there is no folder for cards: set HOME or XDG_DATA_HOME");
    std::error_code error;
    // Errors are ignored here: writing the file reports them.
    fs::create_directories(folder_, error);
    auto const* const label = tools::cards_label(hand.kind());
    std::string name;
    for (int i = 1; name.empty() || fs::exists(file_of(name), error); ++i)
        name = fmt::format("{} {}", label ? label : hand.kind().label, i);
    TRY(write_file(file_of(name), [&](std::ostream& out) -> Result<void> {
        out << tools::card_text(hand);
        return {};
    }));
    return name;
}

// True if the name is valid as a file name on every system, and not hidden.
static bool is_file_name(std::string_view name)
{
    constexpr std::size_t kMaxLetters = 60;
    bool const is_plain = std::none_of(name.begin(), name.end(), [](unsigned char letter) {
        return std::iscntrl(letter) != 0
            || std::string_view("/\\:*?\"<>|").find(static_cast<char>(letter))
            != std::string_view::npos;
    });
    return is_plain && !name.empty() && name.size() <= kMaxLetters && name.front() != '.'
        && name.front() != ' ' && name.back() != ' ';
}

Result<void> CardLibrary::rename(std::string const& from, std::string const& to) const
{
    if (from == to)
        return {};
    if (!is_file_name(to))
        return fail(Fault::User,
                    fmt::format("no card can be called \"{}\": give it letters, digits and spaces "
                                "between them, at most 60",
                                to));
    std::error_code error;
    if (fs::exists(file_of(to), error))
        return fail(Fault::User, fmt::format("there is a card called {} already", to));
    fs::rename(file_of(from), file_of(to), error);
    if (error)
        return fail(Fault::User, fmt::format("{}: {}", file_of(from).string(), error.message()));
    return {};
}

Result<void> CardLibrary::remove(std::string const& name) const
{
    std::error_code error;
    if (!fs::remove(file_of(name), error))
        return fail(Fault::User,
                    fmt::format("{}: {}", file_of(name).string(),
                                error ? error.message() : "it is gone already"));
    return {};
}

} // namespace tractus::controllers
