#pragma once

#include "app/document/model_cost.h"
#include "app/session/session.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::controllers {

// What a person wants to draw on, and where it is kept.
struct WantedDrawing {
    // A model, a skeleton, a measured plant or a session; empty: an empty sheet.
    std::filesystem::path plant {};
    // The session that keeps it: one that is gone on with, or a new one of the plant. Empty: a new
    // one that nobody has named (unnamed_session.h).
    std::filesystem::path session {};
};

// A drawing to go on with.
struct OpenedDrawing {
    std::string name {};   // Of its file, for people.
    scene::Scene scene {}; // Where nothing keeps it, which `trouble` explains.
    std::optional<session::Session> session {};
    std::filesystem::path
        unnamed {};                 // The session's file, if it is a new one that nobody has named.
    std::filesystem::path model {}; // The file of its model in cpfg's language; empty: it has none.
    std::string trouble {};         // What a person should know: a sentence, without its stop.
};

// Opens a drawing. Where a new session that nobody has named has no place, it is opened all the
// same. Fails, as the user's fault, like load_plant_edit(), Session::open() and Session::create().
Result<OpenedDrawing> open_drawing(WantedDrawing const& wanted, scene::EditKinds kinds);

// The session in the file, or a new one of the plant. `trouble` becomes what of it is unknown.
Result<session::Session> open_or_begin(WantedDrawing const& wanted, scene::EditKinds kinds,
                                       std::string& trouble);

// The scene of a plant as it would begin. Fails like load_plant_edit() and load_session_scene().
Result<scene::Scene> scene_of_plant(std::filesystem::path const& plant, scene::EditKinds kinds,
                                    document::ModelCost const& cost = {});

} // namespace tractus::controllers
