#pragma once

#include "engine/base/file.h"

#include <filesystem>

namespace tractus {

// Returns a temporary name beside `target` that no other writer uses, in this process or another:
// "NAME.PROCESS-COUNT.part". The first call for a folder also removes temporary files, and journals
// of temporary databases, that killed processes left there. A file is removed only if it is older
// than a day, since a process that does not exist here may run on another computer.
std::filesystem::path unfinished_path(std::filesystem::path const& target);

// Registers a temporary file while it is unfinished, for the signal handler that removes it when
// the program ends (remove_unfinished_file_on_signals()). The table has a fixed number of places,
// each taken and released atomically. If more files are written at once than there are places, the
// excess ones remain on disk after a signal.
class UnfinishedFile {
public:
    explicit UnfinishedFile(std::filesystem::path const& written);
    ~UnfinishedFile();
    UnfinishedFile(UnfinishedFile const&) = delete;
    UnfinishedFile& operator=(UnfinishedFile const&) = delete;

private:
    struct Place;
    Place* mine_ = nullptr;

    static Place* places();
    static void remove_all_and_die(int signal);
    friend void remove_unfinished_file_on_signals();
};

} // namespace tractus
