#pragma once

#include "app/batch/pictures.h"
#include "engine/base/result.h"

#include <functional>
#include <memory>

namespace tractus::batch {

// Makes pictures on a thread of its own, for whoever asks on any thread.
//
// OpenGL keeps things for each thread that ever used it. Threads of parallel loops end while the
// program does, when the library that keeps them may be gone already; this one ends before.
class PictureThread {
public:
    // Fails like PictureMaker::create(), and where the system gives no thread.
    static Result<PictureThread> create();

    PictureThread(PictureThread&&) noexcept;
    PictureThread& operator=(PictureThread&&) = delete;
    ~PictureThread();

    // Calls `draw` on that thread, and waits until it is done. Others that ask meanwhile wait, too.
    void draw(std::function<void(PictureMaker&)> const& draw);

private:
    struct Shared;
    explicit PictureThread(std::unique_ptr<Shared> shared);

    std::unique_ptr<Shared> shared_;
};

} // namespace tractus::batch
