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

// The steps of a session in memory and the scene that they amount to, so that undo and redo need
// not begin at the first edit: some scenes on the way are kept, the newest ones and a few of old,
// so memory stays bounded however long the session is.
class SessionHistory {
public:
    // Of a session's contents, which has a beginning. Fails where an edit does, saying which.
    static Result<SessionHistory> create(SessionContents contents, MakeLoadOptions load_options);

    Scene const& scene() const { return scene_; }
    std::size_t step() const { return contents_.step; } // The last that counts.
    SessionContents const& contents() const { return contents_; }

    // What the scene would be after one more step. Fails where an edit does.
    Result<Scene> after(std::span<Edit const> edits) const;

    // The scene as it is, or was, at another step.
    Result<Scene> at(std::size_t wanted);

    // Makes this, which leads to `scene`, the next step. What was undone is gone.
    void push(SessionStep const& step, Scene scene);

    // Makes `step` the last that counts; `scene` is what at() gives.
    void go_to(std::size_t step, Scene scene);

private:
    SessionHistory(SessionContents contents, MakeLoadOptions load_options);

    // On from the scene before step `first`.
    Result<Scene> fold(Scene scene, std::size_t first, std::size_t last);
    void keep(std::size_t step, Scene scene);
    bool is_worth_keeping(std::size_t step) const;

    SessionContents contents_;
    MakeLoadOptions load_options_;
    std::vector<std::size_t> first_edit_; // Of each step, into the contents' edits.
    Scene scene_;
    std::map<std::size_t, Scene> kept_; // By step.
};

} // namespace tractus
