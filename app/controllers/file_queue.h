#pragma once

#include "engine/base/newest_job.h"
#include "engine/base/result.h"

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace tractus::controllers {

// A file that somebody wants to have.
struct WantedFile {
    std::filesystem::path path;
    // Is called on another thread, with that path. Gives what else there is to say; empty: nothing.
    std::function<Result<std::string>(std::filesystem::path const& path)> write;
};

// Writes files in the background, one after another, for a window that goes on meanwhile. All that
// were asked for are written, though the window may close before. Belongs to one thread.
class FileQueue {
public:
    FileQueue();
    FileQueue(FileQueue const&) = delete;
    FileQueue& operator=(FileQueue const&) = delete;
    ~FileQueue();

    void add(WantedFile file);

    // Some are not written yet, or their outcome was not taken.
    bool is_busy() const { return is_writing_ || !done_.empty(); }

    // One that has been written since the last call, or why it could not be.
    struct Written {
        std::filesystem::path path;
        std::string note;
    };
    std::optional<Result<Written>> take();

    // Waits until the outcome of all is there to be taken.
    void settle();

private:
    void collect();

    std::deque<WantedFile> waiting_;
    bool is_writing_ = false;
    std::deque<Result<Written>> done_;
    NewestJob<WantedFile, Result<Written>> job_;
};

} // namespace tractus::controllers
