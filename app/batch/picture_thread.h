#pragma once

#include "app/batch/pictures.h"
#include "engine/base/result.h"

#include <functional>
#include <memory>

namespace tractus::batch {

// Renders pictures on a thread of its own, on behalf of any thread. OpenGL keeps data for every
// thread that has used it, and releases them when that thread ends. Worker threads of parallel
// loops end during program exit, when the OpenGL library may already be unloaded; this thread ends
// earlier.
class PictureThread {
public:
    // Fails like PictureMaker::create(), and if no thread can be started.
    static Result<PictureThread> create();

    PictureThread(PictureThread&&) noexcept;
    PictureThread& operator=(PictureThread&&) = delete;
    ~PictureThread();

    // Calls `draw` on the picture thread and waits until it returns. Concurrent callers wait for
    // their turn.
    void draw(std::function<void(PictureMaker&)> const& draw);

private:
    struct Shared;
    explicit PictureThread(std::unique_ptr<Shared> shared);

    std::unique_ptr<Shared> shared_;
};

} // namespace tractus::batch
