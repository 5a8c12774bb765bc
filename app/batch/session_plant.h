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

// Functions for reading a session in place of a model, and for creating sessions.

// True if the path has the extension of a session (.tractus).
bool is_session_file(std::filesystem::path const& path);

// Returns the effective edits of a session, in order. A step that depends on edits lost when the
// session was damaged is left out. Fails like read_session().
Result<std::vector<scene::Edit>> session_edits(std::filesystem::path const& path,
                                               scene::EditKinds kinds);

// Returns the scene that results from a session. Fails like read_session() and fold_session().
Result<scene::Scene> load_session_scene(std::filesystem::path const& path, scene::EditKinds kinds,
                                        document::ModelCost const& cost = {});

// The scene after those steps of a session that can be applied, and the number of skipped steps.
struct FoldedSession {
    scene::Scene scene;
    std::vector<scene::Edit> edits;
    session::UnknownEdits unknown;
    // Number of steps skipped because they depend on lost edits; steps with unknown edits are not
    // counted.
    std::size_t skipped_steps = 0;
};

// Applies the steps of a session, beginning with an empty document. Fails if the first step cannot
// be applied, or if the resulting plants cannot be built.
Result<FoldedSession> fold_session(session::SessionContents const& contents,
                                   document::ModelCost const& cost = {});

// Returns the plant as the window shows it: as drawn, with its own growth and age. Fails like
// plan_growth().
Result<Plant> shown_plant(scene::BuiltPlant const& built);

// Creates a session file that begins with `edits` and records this program's version and the
// current time. Fails like Session::create().
Result<session::Session> begin_session(std::filesystem::path const& path,
                                       std::vector<scene::Edit> const& edits,
                                       scene::EditKinds kinds);

} // namespace tractus::batch
