#include "app/controllers/start_page_controller.h"

#include "app/controllers/drawing_name.h"
#include "app/controllers/recent_drawings.h"
#include "app/controllers/unnamed_session.h"
#include "app/files/resources.h"
#include "app/files/user_folder.h"
#include "engine/base/file.h"

#include <algorithm>
#include <deque>
#include <fmt/core.h>
#include <set>
#include <string_view>
#include <utility>

namespace tractus::controllers {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> models_in(fs::path const& folder)
{
    std::vector<fs::path> models;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().extension() == ".l")
            models.push_back(entry->path());
    std::sort(models.begin(), models.end());
    return models;
}

// Returns a model's description: its first comment up to the full stop. For example, "/* A weeping
// birch: a slender …" gives "A weeping birch". Empty if the model does not begin with a comment.
std::string describe_model(fs::path const& model)
{
    constexpr std::size_t kMax_bytes = 1'000'000;
    auto const text = read_file(model, kMax_bytes);
    constexpr std::string_view kBeginning = "/* ";
    if (!text || !text->starts_with(kBeginning))
        return {};
    auto said = text->substr(kBeginning.size());
    said.resize(std::min(said.find_first_of(":,.;\n*"), said.size()));
    return said;
}

} // namespace

StartPageOptions start_page_of_user(tools::Methods const& methods)
{
    StartPageOptions options { .kinds = methods.edits, .tools = methods.tools };
    if (auto const ours = files::find_resource("models"))
        options.models.push_back(*ours);
    options.sessions = files::user_folder();
    if (!options.sessions.empty())
        options.models.push_back(options.sessions / "models");
    options.pictures = files::user_cache_folder();
    options.now
        = [] { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); };
    return options;
}

StartPageController::StartPageController(StartPageOptions options)
    : options_(std::move(options))
    , pictures_(options_.kinds, options_.pictures)
    , opening_([kinds = options_.kinds](DrawingRequest const& wanted) {
        return open_drawing(wanted, kinds);
    })
{
}

StartPageController::~StartPageController()
{
    opening_.settle();
    auto opened = opening_.take();
    if (!opened || !*opened || (*opened)->unnamed.empty())
        return;
    auto const file = (*opened)->unnamed;
    opened.reset(); // Closes the session, as its file may be deleted next.
    remove_if_nothing_was_drawn(file);
}

void StartPageController::open(std::string note)
{
    is_open_ = true;
    auto const before = pictures_of_models();
    state_.groups.clear();
    meanings_.clear();
    list_sheets();
    list_recent();
    list_models();
    state_.note = std::move(note);
    state_.offers_tour = true;
    state_.is_opening = false;
    ++state_.revision;
    std::deque<fs::path> files;
    for (std::size_t group = 0; group < meanings_.size(); ++group)
        for (std::size_t i = 0; i < meanings_[group].size(); ++i) {
            auto const& [plant, session] = meanings_[group][i].wanted;
            if (auto const known = before.find(plant); known != before.end())
                state_.groups[group].cards[i].picture = known->second;
            else if (auto const& file = session.empty() ? plant : session; !file.empty())
                files.push_back(file);
        }
    pictures_.want(std::move(files));
}

// Returns the thumbnails shown so far that can be reused when the page is opened again. Sessions
// are left out, as they may have changed.
std::map<fs::path, std::shared_ptr<render::Image const>>
StartPageController::pictures_of_models() const
{
    std::map<fs::path, std::shared_ptr<render::Image const>> pictures;
    for (std::size_t group = 0; group < meanings_.size(); ++group)
        for (std::size_t i = 0; i < meanings_[group].size(); ++i)
            if (auto const& picture = state_.groups[group].cards[i].picture; picture)
                pictures.emplace(meanings_[group][i].wanted.plant, picture);
    pictures.erase(fs::path());
    return pictures;
}

void StartPageController::add_group(view::StartCards cards, std::vector<Meaning> meanings)
{
    if (cards.cards.empty())
        return;
    state_.groups.push_back(std::move(cards));
    meanings_.push_back(std::move(meanings));
}

// Offers an empty sheet for each method; the method's first tool is selected on it.
void StartPageController::list_sheets()
{
    view::StartCards cards { .title = "An empty sheet" };
    std::vector<Meaning> meanings;
    std::set<std::string_view> methods;
    for (auto const* const kind : options_.tools) {
        if (*kind->method == 0 || !methods.insert(kind->method).second)
            continue;
        cards.cards.push_back(
            { .title = kind->method, .detail = kind->title, .icon = kind->icon, .key = kind->key });
        meanings.push_back({ {}, tools::Tool(*kind) });
    }
    add_group(std::move(cards), std::move(meanings));
}

void StartPageController::list_models()
{
    view::StartCards cards { .title = "From a model" };
    std::vector<Meaning> meanings;
    for (auto const& folder : options_.models)
        for (auto const& model : models_in(folder)) {
            cards.cards.push_back(
                { .title = name_in_words(model.stem().string()), .detail = describe_model(model) });
            meanings.push_back({ { .plant = model } });
        }
    add_group(std::move(cards), std::move(meanings));
}

void StartPageController::list_recent()
{
    view::StartCards cards { .title = "Recent drawings", .title_of_others = "Earlier drawings" };
    std::vector<Meaning> meanings;
    for (auto const& drawing : recent_drawings(options_.sessions, kMaxRecent, options_.now())) {
        cards.cards.push_back({ .title = drawing.name, .detail = drawing.time });
        meanings.push_back({ { .session = drawing.file } });
    }
    add_group(std::move(cards), std::move(meanings));
}

void StartPageController::advance()
{
    while (auto const made = pictures_.take())
        show_picture(*made);
}

void StartPageController::show_picture(CardPictures::Made const& made)
{
    for (std::size_t group = 0; group < meanings_.size(); ++group)
        for (std::size_t i = 0; i < meanings_[group].size(); ++i) {
            auto const& wanted = meanings_[group][i].wanted;
            if (made.picture && (wanted.plant == made.file || wanted.session == made.file))
                state_.groups[group].cards[i].picture = made.picture;
        }
    ++state_.revision;
}

void StartPageController::choose(std::size_t group, std::size_t card)
{
    if (state_.is_opening || group >= meanings_.size() || card >= meanings_[group].size())
        return;
    auto const& meaning = meanings_[group][card];
    chosen_tool_ = meaning.tool;
    tour_is_chosen_ = false;
    state_.is_opening = true;
    state_.note = fmt::format("Opening {} ...", state_.groups[group].cards[card].title);
    ++state_.revision;
    opening_.want(meaning.wanted);
}

void StartPageController::begin_tour()
{
    if (state_.is_opening)
        return;
    chosen_tool_.reset();
    tour_is_chosen_ = true;
    state_.is_opening = true;
    state_.note = "Opening the tour ...";
    ++state_.revision;
    opening_.want({});
}

std::optional<StartPageController::Chosen> StartPageController::take_opened()
{
    auto opened = opening_.take();
    if (!opened)
        return std::nullopt;
    state_.is_opening = false;
    ++state_.revision;
    if (!*opened) {
        state_.note = fmt::format("It cannot be opened: {}", opened->error().message);
        return std::nullopt;
    }
    is_open_ = false;
    pictures_.want({}); // Stops making thumbnails, so that the drawing has the processor to itself.
    return Chosen { .drawing = **std::move(opened),
                    .tool = std::exchange(chosen_tool_, std::nullopt),
                    .is_for_tour = std::exchange(tour_is_chosen_, false) };
}

void StartPageController::settle()
{
    while (pictures_.is_busy()) {
        advance();
        pictures_.settle();
    }
    opening_.settle();
}

} // namespace tractus::controllers
