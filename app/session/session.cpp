#include "app/session/session.h"

#include "app/session/session_schema.h"
#include "engine/base/check.h"
#include "engine/scene/edit_ids.h"

#include <algorithm>
#include <fmt/core.h>
#include <functional>
#include <utility>

namespace tractus::session {

namespace fs = std::filesystem;

namespace {

// Opens a session's file for writing. Commits are synced to its write-ahead log.
Result<Database> open_to_write(fs::path const& path)
{
    auto database = TRY(open_session(path, Database::Access::Write));
    TRY(database.execute("PRAGMA synchronous = FULL"));
    // In KiB. Small, because the file is seldom read.
    TRY(database.execute("PRAGMA cache_size = -256"));
    TRY(database.execute("BEGIN IMMEDIATE")); // Keeps other programs from writing from now on.
    return database;
}

// Returns a function that reads the store's steps. It is valid until the store is moved or
// destroyed.
ReadStep read_from(SessionStore const& store)
{
    return [&store](std::size_t step) { return store.read_step(step); };
}

// Returns a function that reads the steps of a session in memory; the first element is step 1.
ReadStep read_from(std::vector<std::vector<scene::Edit>> const& steps)
{
    return [&steps](std::size_t step) -> Result<std::vector<SessionEdit>> {
        std::vector<SessionEdit> edits;
        for (auto const& edit : steps[step - 1])
            edits.push_back({ step, edit });
        return edits;
    };
}

// True if a model made one of the plants or a part of one.
bool has_models(scene::DocumentState const& state)
{
    auto const& plants = state.plants;
    return std::any_of(plants.begin(), plants.end(), [](auto const& plant) {
        return scene::loaded_model(plant->source)
            || std::any_of(
                   plant->grafts.begin(), plant->grafts.end(),
                   [](scene::Graft const& graft) { return scene::loaded_model(graft.source); });
    });
}

// Returns the edits with the ids that they get when they are applied to the scene `before`. With
// stored ids, later edits refer to the same objects even after a repair has removed edits from the
// file.
std::vector<scene::Edit> with_ids(std::span<scene::Edit const> edits, scene::Scene const& before)
{
    std::vector<scene::Edit> given;
    for (auto const& edit : edits)
        given.push_back(scene::with_id(edit, before.state.last_edit + given.size() + 1));
    return given;
}

} // namespace

SessionOptions session_by_the_clock(scene::EditKinds kinds, scene::MakeLoadOptions load_options)
{
    return { kinds, std::move(load_options), [] {
                return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
            } };
}

Result<Session> Session::create(fs::path const& path, SessionOrigin const& origin,
                                std::span<scene::Edit const> edits, SessionOptions const& options)
{
    CHECK(!edits.empty());
    auto const read_beginning = [&](std::size_t) {
        std::vector<SessionEdit> beginning;
        for (auto const& edit : edits)
            beginning.push_back(
                { 0, edit, origin.created, { .number = std::ssize(beginning) + 1 } });
        return Result<std::vector<SessionEdit>>(std::move(beginning));
    };
    scene::SceneBuilder builder(options.load_options);
    auto history = TRY(SessionHistory::create({}, read_beginning, builder));
    auto scene = TRY(build_scene(builder, history.state()));
    TRY(write_new_session(path, origin, beginning_rows(edits, origin.created), 0));
    auto database = TRY(open_to_write(path));
    Session session(SessionStore(path, std::move(database), options.kinds), options,
                    std::move(history), std::move(builder), std::move(scene));
    session.name_ = origin.name;
    return session;
}

Session Session::in_memory(scene::Scene beginning, SessionOptions options)
{
    scene::SceneBuilder builder(beginning, options.load_options);
    SessionHistory history(beginning.state);
    return Session(std::nullopt, std::move(options), std::move(history), std::move(builder),
                   std::move(beginning));
}

Result<Session> Session::open(fs::path const& path, SessionOptions options)
{
    auto database = TRY(open_to_write(path));
    TRY(migrate(database, path));
    TRY(database.execute("COMMIT; BEGIN IMMEDIATE"));
    auto const summary = TRY(check_session(database, path.string(), options.kinds));
    bool const is_of_older_language = summary.origin.language < lsystem::kLanguageVersion;
    if (is_of_older_language)
        TRY(write_language(database));
    TRY(database.execute("COMMIT; BEGIN IMMEDIATE"));
    SessionStore store(path, std::move(database), options.kinds);
    scene::SceneBuilder builder(options.load_options);
    auto const build = [&]() -> Result<std::pair<SessionHistory, scene::Scene>> {
        auto history = TRY(
            SessionHistory::create({ summary.step, summary.last_step }, read_from(store), builder));
        auto scene = TRY(build_scene(builder, history.state()));
        return std::pair { std::move(history), std::move(scene) };
    };
    auto built = build();
    if (!built)
        return fail(built.error().fault,
                    fmt::format("{}: {}", path.string(), built.error().message));
    Session session(std::move(store), std::move(options), std::move(built->first),
                    std::move(builder), std::move(built->second));
    session.unknown_ = summary.unknown;
    session.name_ = summary.origin.name;
    session.is_derived_anew_ = is_of_older_language && has_models(session.scene().state);
    return session;
}

Session::Session(std::optional<SessionStore> store, SessionOptions options, SessionHistory history,
                 scene::SceneBuilder builder, scene::Scene scene)
    : store_(std::move(store))
    , options_(std::move(options))
    , history_(std::move(history))
    , builder_(std::move(builder))
    , scene_(std::move(scene))
{
}

Result<std::vector<scene::Edit>> Session::beginning() const
{
    if (!store_)
        return std::vector<scene::Edit> { BeginAgain {} };
    std::vector<scene::Edit> edits;
    for (auto& edit : TRY(store_->read_step(0)))
        if (!edit.edit.get<scene::UnknownEdit>())
            edits.push_back(std::move(edit.edit));
    return edits;
}

Result<void> Session::append(std::span<scene::Edit const> edits)
{
    if (edits.empty())
        return {};
    return keep(TRY(prepare(edits)));
}

Result<Session::Prepared> Session::prepare(std::span<scene::Edit const> edits)
{
    SessionStore::NewStep stored;
    auto given = with_ids(edits, scene());
    if (store_)
        stored = TRY(store_->prepare({ step() + 1, given, options_.now() }));
    else
        stored.edits = std::move(given);
    auto state = TRY(history_.after(stored.edits, builder_));
    auto scene = TRY(builder_.build(std::move(state)));
    return Prepared { std::move(stored), std::move(scene) };
}

Result<void> Session::keep(Prepared prepared)
{
    if (store_) {
        TRY(store_->write(prepared.stored));
    } else {
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(step()), steps_.end());
        steps_.push_back(std::move(prepared.stored.edits));
    }
    history_.push(std::move(prepared.scene.state));
    // Builds the scene again without the new strokes' tips in memory: they are in the file now.
    scene_ = TRY(builder_.build(history_.state()));
    return {};
}

Result<void> Session::undo()
{
    if (!can_undo())
        return fail(Fault::User, "there is nothing to undo: this is how the session began");
    return go_to(step() - 1);
}

Result<void> Session::redo()
{
    if (!can_redo())
        return fail(Fault::User, "there is nothing to redo: the last step was made, not undone");
    return go_to(step() + 1);
}

Result<void> Session::go_to(std::size_t step)
{
    auto state = TRY(history_.at(step, store_ ? read_from(*store_) : read_from(steps_), builder_));
    auto scene = TRY(builder_.build(std::move(state)));
    if (store_)
        TRY(store_->write_cursor(step));
    history_.go_to(step, scene.state);
    scene_ = std::move(scene);
    return {};
}

Result<void> Session::set_name(std::string name)
{
    if (!store_)
        return fail(Fault::User,
                    "there is no file that would keep a name: what is drawn is kept "
                    "in memory alone");
    TRY(store_->write_name(name));
    name_ = std::move(name);
    return {};
}

} // namespace tractus::session
