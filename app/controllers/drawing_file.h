#pragma once

#include "app/document/model_cost.h"
#include "app/session/session.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::controllers {

// A drawing to open: the file that it begins from, and the session that saves it.
struct DrawingRequest {
    // A model, a skeleton, a measured plant or a session; empty: an empty sheet.
    std::filesystem::path plant {};
    // The session to save to: an existing one to continue, or a new one with the plant. Empty: a
    // new one with a generated name (unnamed_session.h).
    std::filesystem::path session {};
};

// An opened drawing.
struct OpenedDrawing {
    std::string name {}; // Display name, made of the file's name.
    // The scene to draw on without a session; `trouble` says why there is none.
    scene::Scene scene {};
    std::optional<session::Session> session {};
    std::filesystem::path unnamed {}; // The session's file if it is new and has a generated name.
    // File of the plant's model in cpfg's language; empty if it has none.
    std::filesystem::path model {};
    std::string trouble {}; // A warning for the user: a sentence without its full stop.
};

// Opens a drawing. If a new session with a generated name cannot be created, the drawing opens
// without one. Fails with a user error like load_plant_edit(), Session::open() and
// Session::create().
Result<OpenedDrawing> open_drawing(DrawingRequest const& wanted, scene::EditKinds kinds);

// Opens an existing session, or creates one with the plant. Sets `trouble` if the session has
// unknown edits.
Result<session::Session> open_or_begin(DrawingRequest const& wanted, scene::EditKinds kinds,
                                       std::string& trouble);

// The scene with which a drawing of this plant begins. Fails like load_plant_edit() and
// load_session_scene().
Result<scene::Scene> scene_of_plant(std::filesystem::path const& plant, scene::EditKinds kinds,
                                    document::ModelCost const& cost = {});

} // namespace tractus::controllers
