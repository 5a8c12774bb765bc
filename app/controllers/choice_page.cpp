#include "app/controllers/choice_page.h"

#include "app/controllers/drawing_name.h"
#include "app/controllers/picture_files.h"
#include "app/methods/all_leaves.h"
#include "app/methods/all_organs.h"

#include <algorithm>
#include <deque>
#include <fmt/core.h>

namespace tractus::controllers {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxOfFolder = 60;

// Returns a folder's display name, such as "home/Pictures".
std::string name_of(fs::path const& folder)
{
    auto const parent = folder.parent_path().filename().string();
    auto const name = folder.filename().string();
    return parent.empty() ? folder.string() : fmt::format("{}/{}", parent, name);
}

std::string where_to_put_one(std::vector<fs::path> const& folders)
{
    std::string places;
    for (auto const& folder : folders)
        places += (places.empty() ? "" : " or ") + folder.string();
    return places.empty()
        ? std::string("There is no folder of pictures: drop a PNG or JPEG file on the window")
        : fmt::format("Put a PNG or JPEG file into {}, or drop one on the window", places);
}

} // namespace

Choices picture_choices(std::vector<fs::path> const& folders)
{
    Choices choices { .question = "Which picture shall lie behind what is drawn?",
                      .if_none = where_to_put_one(folders) };
    for (auto const& folder : folders) {
        auto& group = choices.groups.emplace_back();
        group.title = name_of(folder);
        for (auto const& file : pictures_in(folder, kMaxOfFolder))
            group.choices.push_back({ file.stem().string(),
                                      file.parent_path() == folder
                                          ? std::string()
                                          : file.parent_path().filename().string(),
                                      file });
    }
    return choices;
}

// Adds a choice for each drawn leaf. The choices are numbered if there are several.
static void add_drawn(Choices::Group& group, std::vector<LeavesInDocument::Drawn> const& drawn,
                      char const* one, char const* of_many)
{
    for (std::size_t i = 0; i < drawn.size(); ++i)
        group.choices.push_back(
            { drawn.size() == 1 ? std::string(one) : fmt::format("{} {}", of_many, i + 1),
              drawn[i].on_choice, drawn[i].file });
}

Choices leaf_choices(fs::path const& folder, LeavesInDocument const& document)
{
    Choices choices { .question = "Which leaves shall the plant have?" };
    auto& here = choices.groups.emplace_back();
    here.title = "In this drawing";
    add_drawn(here, document.drawn, "Your leaf", "Leaf");
    add_drawn(here, document.in_views, "Your leaf in three views", "Leaf in three views");
    if (!document.kept.empty())
        here.choices.push_back({ "What it wears", "Kept in the drawing", document.kept });
    auto& own = choices.groups.emplace_back();
    own = { "The plant's own, and yours", { { "Its own", "As it was drawn or modelled", {} } } };
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        auto const& file = entry->path();
        bool const is_in_views = methods::is_organ_file(file);
        if (file.extension() == ".leaf" || (is_in_views && document.takes_views))
            own.choices.push_back(
                { file.stem().string(), is_in_views ? "In three views" : "", file });
    }
    // Choices are sorted by file; the choice "none" has an empty path and comes first.
    std::ranges::sort(own.choices, {}, &Choices::Choice::file);
    if (document.takes_views) {
        auto& in_views = choices.groups.emplace_back();
        in_views.title = "In three views, for the pen to go on with";
        for (auto const& [name, file] : methods::organ_kinds())
            in_views.choices.push_back({ name_in_words(name), {}, file });
    }
    auto& ours = choices.groups.emplace_back();
    ours.title = "Species";
    for (auto const& [name, grammar] : methods::leaf_kinds())
        ours.choices.push_back({ name_in_words(name), {}, grammar });
    return choices;
}

ChoicePage::ChoicePage(fs::path const& small_pictures)
    : pictures_({}, small_pictures)
{
    state_.is_beside_drawing = true;
}

void ChoicePage::open(Choices choices)
{
    is_open_ = true;
    chosen_.reset();
    state_.groups.clear();
    state_.title = std::move(choices.question);
    files_.clear();
    std::deque<fs::path> wanted;
    for (auto& [title, of_group] : choices.groups) {
        if (of_group.empty())
            continue;
        view::StartCards cards { .title = std::move(title) };
        auto& files = files_.emplace_back();
        for (auto& choice : of_group) {
            if (!choice.file.empty())
                wanted.push_back(choice.file);
            files.push_back(choice.file);
            cards.cards.push_back(
                { .title = std::move(choice.title), .detail = std::move(choice.detail) });
        }
        state_.groups.push_back(std::move(cards));
    }
    state_.note = files_.empty() ? std::move(choices.if_none) : std::string();
    ++state_.revision;
    pictures_.want(std::move(wanted));
}

void ChoicePage::advance()
{
    while (auto const made = pictures_.take())
        show_picture(*made);
}

void ChoicePage::settle()
{
    while (pictures_.is_busy()) {
        advance();
        pictures_.settle();
    }
    advance();
}

void ChoicePage::show_picture(CardPictures::Made const& made)
{
    for (std::size_t group = 0; group < files_.size(); ++group)
        for (std::size_t i = 0; i < files_[group].size(); ++i)
            if (files_[group][i] == made.file)
                state_.groups[group].cards[i].picture = made.picture;
    ++state_.revision;
}

void ChoicePage::choose(std::size_t group, std::size_t card)
{
    if (group >= files_.size() || card >= files_[group].size())
        return;
    chosen_ = files_[group][card];
    leave();
}

void ChoicePage::leave()
{
    is_open_ = false;
    pictures_.want({}); // Stops making thumbnails, so that the drawing has the processor to itself.
    ++state_.revision;
}

} // namespace tractus::controllers
