#pragma once

#include "drivers/logs/log_text.h"

#include <unistd.h>

namespace tractus::drivers {

// The part of a log that is not in memory: its file, and the position where that part begins.
struct LogRemainder {
    explicit LogRemainder(int open_file)
        : file(open_file)
    {
    }
    ~LogRemainder()
    {
        if (file >= 0)
            ::close(file);
    }
    LogRemainder(LogRemainder const&) = delete;
    LogRemainder& operator=(LogRemainder const&) = delete;

    int file; // Descriptor of the log file, open for reading; owned.
    LogPlace place {};
    LogTotals totals {}; // Totals of the whole log.
};

} // namespace tractus::drivers
