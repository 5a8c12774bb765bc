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
    // Begins a session in a new file, created atomically. `edits`, at least one and usually the
    // loading of a plant, are the beginning, where undo ends. Fails with a user error if the
    // file exists or cannot be written, and if an edit fails.
    static Result<Session> create(std::filesystem::path const& path, SessionOrigin const& origin,
                                  std::span<scene::Edit const> edits,
                                  SessionOptions const& options);

    // Opens a session to continue it. A file of an older format is updated; the original stays
    // beside it, with ".bak" appended to its name. Fails like read_session(), and if another
    // program draws in it or it is not writable.
    static Result<Session> open(std::filesystem::path const& path, SessionOptions options);

    // Begins a session without a file with this scene, where undo ends.
    static Session in_memory(scene::Scene beginning, SessionOptions options);

    bool is_in_file() const { return store_.has_value(); }
    // Call only if is_in_file().
    std::filesystem::path const& path() const { return store_->path(); }

    // The current scene. Its plants are built once, from the result of all steps. In a session with
    // a file, the tips of its strokes are not in memory: see SessionStore.
    scene::Scene const& scene() const { return scene_; }

    // Edits that this program did not know when it opened the file.
    UnknownEdits const& unknown() const { return unknown_; }

    // True if the file was last drawn in by an earlier tractus whose model language differed:
    // plants of models are derived anew and may look different. It happens once; from then on they
    // stay as they are now.
    bool is_derived_anew() const { return is_derived_anew_; }

    // Edits that lead from any scene of the session back to its first one: those of step 0, without
    // unknown ones. Fails if the file was damaged after it was opened.
    Result<std::vector<scene::Edit>> beginning() const;

    std::size_t step() const { return history_.step(); } // The current step; later ones are undone.
    std::size_t last_step() const { return history_.last_step(); }

    // Makes a new step of edits that belong together, such as those of a stroke. Steps that were
    // undone are discarded. Without edits nothing happens.
    Result<void> append(std::span<scene::Edit const> edits);

    // The two halves of append(), for callers that show a step's result before it is on disk.
    // Nothing else may be done with the session between them.
    struct Prepared {
        SessionStore::NewStep stored;
        scene::Scene scene; // The scene after the step.
    };
    Result<Prepared> prepare(std::span<scene::Edit const> edits); // `edits` is not empty.
    Result<void> keep(Prepared prepared);

    // Undo the last step, or redo the next one. Undo goes back to the beginning.
    bool can_undo() const { return step() > 0; }
    bool can_redo() const { return step() < last_step(); }
    Result<void> undo();
    Result<void> redo();

    // The name that the user gave the session; empty if none. Setting it is not a step. Fails with
    // a user error if it cannot be written, as without a file.
    std::string const& name() const { return name_; }
    Result<void> set_name(std::string name);

private:
    Session(std::optional<SessionStore> store, SessionOptions options, SessionHistory history,
            scene::SceneBuilder builder, scene::Scene scene);

    Result<void> go_to(std::size_t step);

    std::optional<SessionStore> store_;
    // Steps after the beginning; used only without a store.
    std::vector<std::vector<scene::Edit>> steps_ {};
    SessionOptions options_;
    SessionHistory history_;
    scene::SceneBuilder builder_;
    scene::Scene scene_; // Built from the history's current state.
    UnknownEdits unknown_;
    bool is_derived_anew_ = false;
    std::string name_;
};

} // namespace tractus::session
