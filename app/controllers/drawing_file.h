#pragma once

#include "app/document/model_cost.h"
#include "app/session/session.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::controllers {

// A request to open a drawing: the file with which the drawing begins, and the session that saves
// it.
struct DrawingRequest {
    // A model, a skeleton, a measured plant or a session; empty: an empty sheet.
    std::filesystem::path plant {};
    // Session file that saves the drawing: an existing one, which is continued, or a new one, which
    // begins with `plant`. Empty: a new session with a generated name (unnamed_session.h).
    std::filesystem::path session {};
};

// An opened drawing.
struct OpenedDrawing {
    std::string name {}; // Display name of the drawing, made from its file's name.
    // The scene to draw on if `session` has no value; `trouble` then says why.
    scene::Scene scene {};
    std::optional<session::Session> session {};
    // File of `session` if it is new and has a generated name; otherwise empty.
    std::filesystem::path unnamed {};
    // File of the plant's model in cpfg's language; empty if the plant has no such model.
    std::filesystem::path model {};
    std::string trouble {}; // A warning for the user: a sentence without its full stop.
};

// Opens a drawing. If a new session with a generated name cannot be created, the drawing opens
// without one. Fails with a user error like load_plant_edit(), Session::open() and
// Session::create().
Result<OpenedDrawing> open_drawing(DrawingRequest const& wanted, scene::EditKinds kinds);

// Opens an existing session, or creates one that begins with the plant. Sets `trouble` if the
// session contains unknown edits.
Result<session::Session> open_or_begin(DrawingRequest const& wanted, scene::EditKinds kinds,
                                       std::string& trouble);

// Returns the scene with which a drawing of this plant begins. Fails like load_plant_edit() and
// load_session_scene().
Result<scene::Scene> scene_of_plant(std::filesystem::path const& plant, scene::EditKinds kinds,
                                    document::ModelCost const& cost = {});

} // namespace tractus::controllers
