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

// Reading sessions in place of a model, and creating sessions.

// True if the path has the extension of a session (.tractus).
bool is_session_file(std::filesystem::path const& path);

// The effective edits of a session, in order. A step is left out if it depends on something lost
// when the session was damaged. Fails like read_session().
Result<std::vector<scene::Edit>> session_edits(std::filesystem::path const& path,
                                               scene::EditKinds kinds);

// The scene of a session. Fails like read_session() and fold_session().
Result<scene::Scene> load_session_scene(std::filesystem::path const& path, scene::EditKinds kinds,
                                        document::ModelCost const& cost = {});

// Scene of a session's edits as far as they can be applied, and the number of steps that cannot.
struct FoldedSession {
    scene::Scene scene;
    std::vector<scene::Edit> edits;
    session::UnknownEdits unknown;
    // Steps skipped because they depend on lost ones; steps with unknown edits are not counted.
    std::size_t skipped_steps = 0;
};

// Applies the steps of a session to a scene. Fails if the first step cannot be applied, or if the
// plants of the scene cannot be built.
Result<FoldedSession> fold_session(session::SessionContents const& contents,
                                   document::ModelCost const& cost = {});

// A plant as the window shows it: as drawn, with its own growth and age. Fails like plan_growth().
Result<Plant> shown_plant(scene::BuiltPlant const& built);

// Creates a session of this program, with the current time, that begins with `edits`. Fails like
// Session::create().
Result<session::Session> begin_session(std::filesystem::path const& path,
                                       std::vector<scene::Edit> const& edits,
                                       scene::EditKinds kinds);

} // namespace tractus::batch
