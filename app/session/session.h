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
    // Kinds of edits known to the program; others in a file become UnknownEdits.
    scene::EditKinds kinds;
    scene::MakeLoadOptions load_options;
    // Returns the wall-clock time, which is stored with each step.
    std::function<std::chrono::sys_seconds()> now;
};

// Options with the system's clock. Models run within the limits of `load_options`.
SessionOptions session_by_the_clock(scene::EditKinds kinds, scene::MakeLoadOptions load_options);

// A drawing that is stored in a file (session_file.h) while it is drawn. When a call returns, its
// effect is on disk and survives a crash of the program or machine. When a call fails, nothing has
// changed. Only one program at a time can draw in a session; others can read it meanwhile.
//
// A session without a file keeps its steps in memory and is lost when the program ends.
class Session {
public:
    // Begins a session in a new file, created atomically. `edits` are the beginning, where undo
    // ends: at least one edit, in most cases one that loads a plant. Fails with a user error if the
    // file exists or cannot be written, and if an edit fails.
    static Result<Session> create(std::filesystem::path const& path, SessionOrigin const& origin,
                                  std::span<scene::Edit const> edits,
                                  SessionOptions const& options);

    // Opens a session to continue it. A file of an older format is updated; the original file is
    // kept beside it, with ".bak" appended to its name. Fails with a user error if the file is not
    // a session, is damaged, newer than this program or not writable, if another program draws in
    // the session, or if a plant cannot be built.
    static Result<Session> open(std::filesystem::path const& path, SessionOptions options);

    // Begins a session without a file. Undo ends at the scene `beginning`.
    static Session in_memory(scene::Scene beginning, SessionOptions options);

    bool is_in_file() const { return store_.has_value(); }
    // Call only if is_in_file().
    std::filesystem::path const& path() const { return store_->path(); }

    // The current scene, with the result of all steps. In a session with a file, the tips of the
    // scene's strokes are not in memory (see SessionStore).
    scene::Scene const& scene() const { return scene_; }

    // Edits that this program did not know when it opened the file.
    UnknownEdits const& unknown() const { return unknown_; }

    // True if the file was last drawn in by an earlier tractus whose model language differed.
    // Plants of models are then derived anew with this program's language and may look different.
    // This happens only once per change of the language, since the file now stores the new version.
    bool is_derived_anew() const { return is_derived_anew_; }

    // Edits that lead from any scene of the session back to its first scene: those of step 0,
    // without UnknownEdits. Fails if the file was damaged after it was opened.
    Result<std::vector<scene::Edit>> beginning() const;

    // The current step; later steps are undone.
    std::size_t step() const { return history_.step(); }
    std::size_t last_step() const { return history_.last_step(); }

    // Makes a new step from edits that belong together, such as those of one stroke. Steps that
    // were undone are discarded. Does nothing if there are no edits.
    Result<void> append(std::span<scene::Edit const> edits);

    // prepare() and keep() are the two halves of append(), for callers that show a step's result
    // before it is on disk. Nothing else may be done with the session between the two calls.
    struct Prepared {
        SessionStore::NewStep stored;
        scene::Scene scene; // The scene after the step.
    };
    Result<Prepared> prepare(std::span<scene::Edit const> edits); // `edits` must not be empty.
    Result<void> keep(Prepared prepared);

    // undo() undoes the last step and redo() redoes the next one. Undo ends at the beginning.
    bool can_undo() const { return step() > 0; }
    bool can_redo() const { return step() < last_step(); }
    Result<void> undo();
    Result<void> redo();

    // The name that the user gave the session; empty if none. Setting the name is not a step. Fails
    // with a user error if the name cannot be written, or if the session has no file.
    std::string const& name() const { return name_; }
    Result<void> set_name(std::string name);

private:
    Session(std::optional<SessionStore> store, SessionOptions options, SessionHistory history,
            scene::SceneBuilder builder, scene::Scene scene);

    Result<void> go_to(std::size_t step);

    std::optional<SessionStore> store_;
    // Edits of all steps after the beginning, if the session has no file; otherwise empty.
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
