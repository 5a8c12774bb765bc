#pragma once

#include "app/session/session_file.h"
#include "app/session/session_history.h"
#include "app/session/session_store.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_builder.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tractus::session {

struct SessionOptions {
    scene::EditKinds kinds; // Kinds of edits that a file may have; others become UnknownEdits.
    scene::MakeLoadOptions load_options;
    std::function<std::chrono::sys_seconds()> now; // Wall clock, for the times of steps.
};

// Options with the system's clock; models run within the limits of `load_options`.
SessionOptions session_by_the_clock(scene::EditKinds kinds, scene::MakeLoadOptions load_options);

// A drawing that is stored in a file (session_file.h) while it is drawn. When a call returns, its
// effect is on disk and survives a crash of the program or machine; when it fails, nothing has
// changed. Only one program at a time can draw in a session; others can read it meanwhile.
//
// A session without a file keeps its steps in memory and ends with the program.
class Session {
public:
    // Begins a session in a new file, which appears whole. `edits` are what it begins with, at
    // least one, usually loading a plant; undo ends there. Fails, as the user's fault, if the file
    // is there already or cannot be written, and where an edit fails.
    static Result<Session> create(std::filesystem::path const& path, SessionOrigin const& origin,
                                  std::span<scene::Edit const> edits,
                                  SessionOptions const& options);

    // Goes on with a session. One of an older format is brought up to date, and stays beside it as
    // it was, with ".bak" after its name. Fails like read_session(), and if another program draws
    // in it or it may not be written.
    static Result<Session> open(std::filesystem::path const& path, SessionOptions options);

    // Begins a session without a file at a scene, where undo ends.
    static Session in_memory(scene::Scene beginning, SessionOptions options);

    bool is_in_file() const { return store_.has_value(); }
    std::filesystem::path const& path() const { return store_->path(); } // Path of the file.

    // The scene; its plants are built once, from what all steps amount to. Of a session in a file
    // the tips of its strokes are not in memory: see SessionStore.
    scene::Scene const& scene() const { return scene_; }

    // The edits that this program did not know when it was opened.
    UnknownEdits const& unknown() const { return unknown_; }

    // An earlier tractus drew in it last, to which models meant something else: plants of models
    // are derived anew and may differ. Once; from then on they are what they are now.
    bool is_derived_anew() const { return is_derived_anew_; }

    // Edits that lead from any scene of it to the one that it began with: those of step 0, without
    // what is unknown. Fails where its file was damaged since it was opened.
    Result<std::vector<scene::Edit>> beginning() const;

    std::size_t step() const { return history_.step(); } // The last that counts.
    std::size_t last_step() const { return history_.last_step(); }

    // Makes edits that belong together, such as those of a stroke, the next step. What was undone
    // cannot be redone any more. No edits are no step.
    Result<void> append(std::span<scene::Edit const> edits);

    // Two parts of append(), for those who show what a step makes before the disk has it. Between
    // them nothing else is done with the session.
    struct Prepared {
        SessionStore::NewStep stored;
        scene::Scene scene; // After the step.
    };
    Result<Prepared> prepare(std::span<scene::Edit const> edits); // Takes at least one edit.
    Result<void> keep(Prepared prepared);

    // Take the last step back, or do the next one again. Without limit, but for the beginning.
    bool can_undo() const { return step() > 0; }
    bool can_redo() const { return step() < last_step(); }
    Result<void> undo();
    Result<void> redo();

    // What a person calls it; empty: nothing. It is no step. Fails, as the user's fault, where it
    // cannot be written, as without a file.
    std::string const& name() const { return name_; }
    Result<void> set_name(std::string name);

private:
    Session(std::optional<SessionStore> store, SessionOptions options, SessionHistory history,
            scene::SceneBuilder builder, scene::Scene scene);

    Result<void> go_to(std::size_t step);

    std::optional<SessionStore> store_;
    // Steps after the beginning, if there is no store.
    std::vector<std::vector<scene::Edit>> steps_ {};
    SessionOptions options_;
    SessionHistory history_;
    scene::SceneBuilder builder_;
    scene::Scene scene_; // The scene of the history's state.
    UnknownEdits unknown_;
    bool is_derived_anew_ = false;
    std::string name_;
};

} // namespace tractus::session
