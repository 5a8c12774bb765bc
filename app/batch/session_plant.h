#pragma once

#include "app/document/model_cost.h"
#include "app/session/session.h"
#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::batch {

// Sessions where a model may stand, and new ones.

// True for a session's file (.tractus), by its ending alone.
bool is_session_file(std::filesystem::path const& path);

// The edits of a session that count and can be made, in order: a step that needs what was lost when
// the session was damaged is left out. Fails like read_session().
Result<std::vector<scene::Edit>> session_edits(std::filesystem::path const& path,
                                               scene::EditKinds kinds);

// Returns the scene that they amount to. Fails like read_session() and fold_session().
Result<scene::Scene> load_session_scene(std::filesystem::path const& path, scene::EditKinds kinds,
                                        document::ModelCost const& cost = {});

// Scene that the edits of a session amount to, as far as they can be made, and how many of its
// steps cannot.
struct FoldedSession {
    scene::Scene scene;
    std::vector<scene::Edit> edits;
    session::UnknownEdits unknown;
    // Steps that need what was lost; those with unknown edits apart.
    std::size_t skipped_steps = 0;
};

// Folds the steps of a session into a scene. Fails where the first step cannot be made, or the
// plants of the scene cannot be built.
Result<FoldedSession> fold_session(session::SessionContents const& contents,
                                   document::ModelCost const& cost = {});

// A plant as the station's window shows it: as drawn, grown as is set, at its age. Fails like
// plan_growth().
Result<Plant> shown_plant(scene::BuiltPlant const& built);

// Begins a session that this program, at this time, begins with `edits`. Fails like
// Session::create().
Result<session::Session> begin_session(std::filesystem::path const& path,
                                       std::vector<scene::Edit> const& edits,
                                       scene::EditKinds kinds);

} // namespace tractus::batch
