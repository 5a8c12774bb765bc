#pragma once

#include "app/session/session_file.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace tractus {

// Gives what each model may cost from that moment on.
using MakeLoadOptions = std::function<LoadOptions()>;

// The edits of a step, which somebody keeps.
using ReadStep = std::function<Result<std::vector<SessionEdit>>(std::size_t step)>;

// How far a session has come.
struct SessionExtent {
    std::size_t step = 0; // The last that counts.
    std::size_t last_step = 0;
};

// Takes everything back to the scene that a history began with. For steps in memory alone: a
// session's file has the edits of its beginning.
struct BeginAgain {
    static EditKind const kKind;
};

// The scene that the steps of a session amount to. The steps themselves are read when they are
// needed; so that undo and redo need not begin at the first, some scenes on the way are kept, the
// newest ones and a few of old. The tips of strokes are left to their source, if they have one
// (SharedVector), and read again by who needs them. So memory stays bounded however long the
// session is, but for some 200 bytes for each stroke that still counts.
class SessionHistory {
public:
    // Of a session that has a beginning. Fails where an edit of that does, saying which, and where
    // reading does. A later step whose edits cannot be made changes nothing: what they need was
    // lost when the session was damaged, or this program does not know one of them.
    static Result<SessionHistory> create(SessionExtent const& extent, ReadStep const& read,
                                         MakeLoadOptions load_options);

    // Of a session without steps, whose beginning is a scene.
    SessionHistory(Scene beginning, MakeLoadOptions load_options);

    Scene const& scene() const { return scene_; }
    std::size_t step() const { return extent_.step; }
    std::size_t last_step() const { return extent_.last_step; }

    // What the scene would be after one more step, whose tips are in memory. Fails where an edit
    // does.
    Result<Scene> after(std::span<Edit const> edits) const;

    // The scene as it is, or was, at another step. Fails where reading does.
    Result<Scene> at(std::size_t wanted, ReadStep const& read);

    // The next step is in the file, and leads to `scene`. What was undone is gone.
    void push(Scene scene);

    // Makes `step` the last that counts; `scene` is what at() gives.
    void go_to(std::size_t step, Scene scene);

private:
    SessionHistory(SessionExtent const& extent, MakeLoadOptions load_options);

    // On from the scene before step `first`.
    Result<Scene> fold(Scene scene, std::size_t first, std::size_t last, ReadStep const& read);
    Result<Scene> begin(std::span<SessionEdit const> edits) const;
    Scene apply_step(Scene scene, std::span<SessionEdit const> edits) const;
    Result<Scene> apply(Scene scene, Edit const& edit) const;
    void keep(std::size_t step, Scene scene);
    bool is_worth_keeping(std::size_t step) const;

    SessionExtent extent_;
    MakeLoadOptions load_options_;
    Scene scene_;
    std::map<std::size_t, Scene> kept_; // By step.
};

} // namespace tractus
