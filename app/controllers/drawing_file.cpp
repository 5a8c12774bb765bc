#include "app/controllers/drawing_file.h"

#include "app/batch/session_plant.h"
#include "app/controllers/unnamed_session.h"
#include "app/io/model_file.h"
#include "app/session/begin_empty.h"

#include <chrono>
#include <fmt/core.h>
#include <utility>
#include <vector>

namespace tractus::controllers {

namespace fs = std::filesystem;

// Returns the edits with which a new session of the plant begins.
static Result<std::vector<scene::Edit>> edits_of_plant(fs::path const& plant,
                                                       scene::EditKinds kinds)
{
    if (plant.empty())
        return std::vector<scene::Edit> { session::BeginEmpty {} };
    if (batch::is_session_file(plant))
        return batch::session_edits(plant, kinds);
    auto edit = TRY(io::load_plant_edit(plant));
    return std::vector<scene::Edit> { std::move(edit) };
}

Result<scene::Scene> scene_of_plant(fs::path const& plant, scene::EditKinds kinds,
                                    document::ModelCost const& cost)
{
    if (plant.empty())
        return scene::Scene {};
    if (batch::is_session_file(plant))
        return batch::load_session_scene(plant, kinds, cost);
    auto const edit = TRY(io::load_plant_edit(plant));
    return scene::apply_edit({}, edit, document::make_load_options(cost));
}

Result<session::Session> open_or_begin(DrawingRequest const& wanted, scene::EditKinds kinds,
                                       std::string& trouble)
{
    std::error_code ignored;
    if (!fs::exists(wanted.session, ignored))
        return batch::begin_session(wanted.session, TRY(edits_of_plant(wanted.plant, kinds)),
                                    kinds);
    auto session
        = TRY(session::Session::open(wanted.session, session::session_by_the_clock(kinds, [] {
                                         return document::load_options();
                                     })));
    if (auto const said = session.unknown().sentence(); !said.empty())
        trouble = fmt::format("{}: {}", wanted.session.string(), said);
    else if (session.is_derived_anew())
        trouble = fmt::format("{}: an earlier tractus drew in it, to which some models meant "
                              "something else; its plants are derived anew and may differ",
                              wanted.session.string());
    return session;
}

// Begins a new session with a name generated from the plant's. If its file cannot be created, the
// drawing has no session.
static Result<OpenedDrawing> begin_unnamed(DrawingRequest wanted, scene::EditKinds kinds)
{
    OpenedDrawing opened;
    auto const name = wanted.plant.empty() ? std::string("drawing") : wanted.plant.stem().string();
    auto const begin = [&]() -> Result<session::Session> {
        auto const now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
        wanted.session = TRY(unnamed_session_path(name, now));
        return open_or_begin(wanted, kinds, opened.trouble);
    };
    auto session = begin();
    opened.name = name;
    if (session) {
        opened.session = *std::move(session);
        opened.unnamed = wanted.session;
        return opened;
    }
    // Fails here if no session could be created because the plant itself cannot be loaded.
    opened.scene = TRY(scene_of_plant(wanted.plant, kinds));
    opened.trouble = "what is drawn is not kept: " + session.error().message;
    return opened;
}

static Result<OpenedDrawing> open_named(DrawingRequest const& wanted, scene::EditKinds kinds)
{
    OpenedDrawing opened;
    opened.session = TRY(open_or_begin(wanted, kinds, opened.trouble));
    opened.name
        = opened.session->name().empty() ? wanted.session.stem().string() : opened.session->name();
    return opened;
}

Result<OpenedDrawing> open_drawing(DrawingRequest const& wanted, scene::EditKinds kinds)
{
    auto opened
        = TRY(wanted.session.empty() ? begin_unnamed(wanted, kinds) : open_named(wanted, kinds));
    if (wanted.plant.extension() == ".l")
        opened.model = wanted.plant;
    return opened;
}

} // namespace tractus::controllers
