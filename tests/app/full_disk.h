#pragma once

#include <csignal>
#include <cstddef>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace tractus {

// While one of these is there, no file of this process may grow beyond so many bytes: what a disk
// that is full looks like to whoever writes.
class FullDisk {
public:
    explicit FullDisk(std::size_t most_bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN); // An error of the write, as a full disk's.
        EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &before_), 0);
        rlimit limit = before_;
        limit.rlim_cur = most_bytes;
        EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    }
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }
    FullDisk(FullDisk const&) = delete;
    FullDisk& operator=(FullDisk const&) = delete;

private:
    rlimit before_ {};
};

} // namespace tractus
