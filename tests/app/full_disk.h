#pragma once

#include <csignal>
#include <cstddef>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace tractus {

// While a FullDisk exists, no file of this process can grow beyond a given size, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(std::size_t most_bytes)
    {
        // A write beyond the limit then fails with an error, as on a full disk, instead of sending
        // a signal.
        std::signal(SIGXFSZ, SIG_IGN);
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
