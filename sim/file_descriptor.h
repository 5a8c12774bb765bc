#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string_view>
#include <utility>

namespace tractus::sim {

// Owner of an open file descriptor, closed by the destructor. Empty by default.
class FileDescriptor {
public:
    FileDescriptor() = default;
    explicit FileDescriptor(int number)
        : number_(number)
    {
    }
    ~FileDescriptor() { close(); }

    FileDescriptor(FileDescriptor&& other) noexcept
        : number_(std::exchange(other.number_, -1))
    {
    }
    FileDescriptor& operator=(FileDescriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }

    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; } // Returns the descriptor; -1 if empty.
    void close();

private:
    int number_ = -1;
};

// Opens a file provided by the kernel with the `flags` of open(2), and O_CLOEXEC. Fails with a user
// error whose message ends with `remedy`, a sentence that says what to do.
Result<FileDescriptor> open_kernel_file(std::filesystem::path const& path, int flags,
                                        std::string_view remedy);

} // namespace tractus::sim
