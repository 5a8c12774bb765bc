#pragma once

#include "engine/base/newest_job.h"
#include "engine/base/result.h"

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace tractus::controllers {

// A file to be written in the background.
struct FileToWrite {
    std::filesystem::path path;
    // Writes the file; called with `path` on another thread. Returns an additional message for the
    // user, or "".
    std::function<Result<std::string>(std::filesystem::path const& path)> write;
};

// Writes files in the background, one after another. All requested files are written, even if the
// window is closed earlier. Use from one thread.
class FileQueue {
public:
    FileQueue();
    FileQueue(FileQueue const&) = delete;
    FileQueue& operator=(FileQueue const&) = delete;
    ~FileQueue();

    void add(FileToWrite file);

    // True while files remain to be written, or outcomes have not been taken with take().
    bool is_busy() const { return is_writing_ || !done_.empty(); }

    // A file that was written, with an additional message for the user.
    struct Written {
        std::filesystem::path path;
        std::string note;
    };
    std::optional<Result<Written>> take();

    // Waits until all files are finished; take() can then return their outcomes.
    void settle();

private:
    void collect();

    std::deque<FileToWrite> waiting_;
    bool is_writing_ = false;
    std::deque<Result<Written>> done_;
    NewestJob<FileToWrite, Result<Written>> job_;
};

} // namespace tractus::controllers
