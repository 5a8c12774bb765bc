#include "app/controllers/file_queue.h"

#include <utility>

namespace tractus::controllers {

static Result<FileQueue::Written> write_wanted(FileToWrite const& file)
{
    auto note = TRY(file.write(file.path));
    return FileQueue::Written { file.path, std::move(note) };
}

FileQueue::FileQueue()
    : job_(write_wanted)
{
}

FileQueue::~FileQueue()
{
    settle();
}

void FileQueue::add(FileToWrite file)
{
    waiting_.push_back(std::move(file));
    collect();
}

// Takes the outcome of a finished file, so that the next file can begin.
void FileQueue::collect()
{
    if (auto written = job_.take()) {
        done_.push_back(*std::move(written));
        is_writing_ = false;
    }
    if (is_writing_ || waiting_.empty())
        return;
    job_.want(std::move(waiting_.front()));
    waiting_.pop_front();
    is_writing_ = true;
}

std::optional<Result<FileQueue::Written>> FileQueue::take()
{
    collect();
    if (done_.empty())
        return std::nullopt;
    auto written = std::move(done_.front());
    done_.pop_front();
    return written;
}

void FileQueue::settle()
{
    while (is_writing_) {
        job_.settle();
        collect();
    }
}

} // namespace tractus::controllers
