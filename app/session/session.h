#pragma once

#include "app/session/session_file.h"
#include "app/session/session_history.h"
#include "app/session/session_store.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace tractus {

struct SessionOptions {
    MakeLoadOptions load_options;
    std::function<std::chrono::sys_seconds()> now; // The clock on the wall: when steps are made.
};

// By the system's clock, models cost what `load_options` says.
SessionOptions session_by_the_clock(MakeLoadOptions load_options);

// What somebody draws, kept in a file (session_file.h) as it is drawn. When a call here returns
// what it did is on the disk, whatever becomes of the program or the machine; when it fails nothing
// has changed. One program at a time draws in a session; others may read it meanwhile.
class Session {
public:
    // Begins a session in a new file, which appears whole. `edits` are what it begins with, at
    // least one, usually loading a plant; undo ends there. Fails, as the user's fault, if the file
    // is there already or cannot be written, and where an edit fails.
    static Result<Session> create(std::filesystem::path const& path, SessionOrigin const& origin,
                                  std::span<Edit const> edits, SessionOptions options);

    // Goes on with a session. One of an older format is brought up to date, and stays beside it as
    // it was, with ".bak" after its name. Fails like read_session(), and if another program draws
    // in it or it may not be written.
    static Result<Session> open(std::filesystem::path const& path, SessionOptions options);

    std::filesystem::path const& path() const { return store_.path(); }

    // The tips of its strokes are not in memory: see SessionStore.
    Scene const& scene() const { return history_.scene(); }

    // What of it this program did not know when it was opened.
    UnknownEdits const& unknown() const { return unknown_; }

    // What it began with: step 0, without what is unknown. Fails where the file was damaged since
    // it was opened.
    Result<std::vector<Edit>> beginning() const;

    std::size_t step() const { return history_.step(); } // The last that counts.
    std::size_t last_step() const { return history_.last_step(); }

    // Makes edits that belong together, such as those of a stroke, the next step. What was undone
    // cannot be redone any more. No edits are no step.
    Result<void> append(std::span<Edit const> edits);

    // Take the last step back, or do the next one again. Without limit, but for the beginning.
    bool can_undo() const { return step() > 0; }
    bool can_redo() const { return step() < last_step(); }
    Result<void> undo();
    Result<void> redo();

private:
    Session(SessionStore store, SessionOptions options, SessionHistory history,
            UnknownEdits unknown);

    Result<void> go_to(std::size_t step);

    SessionStore store_;
    SessionOptions options_;
    SessionHistory history_;
    UnknownEdits unknown_;
};

} // namespace tractus
