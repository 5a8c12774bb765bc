#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string_view>
#include <utility>

namespace tractus::sim {

// An open file of the system's, closed with the value. Empty by default.
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
    int number() const { return number_; } // -1 if empty.
    void close();

private:
    int number_ = -1;
};

// Opens a file that the kernel makes: `flags` as open(2) takes them, and closed in programs that
// this one starts. Fails, as the user's fault, with `remedy`: what to do about it.
Result<FileDescriptor> open_kernel_file(std::filesystem::path const& path, int flags,
                                        std::string_view remedy);

} // namespace tractus::sim
