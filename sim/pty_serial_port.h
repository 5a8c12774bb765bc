#pragma once

#include "engine/base/result.h"
#include "sim/file_descriptor.h"
#include "sim/kernel_device.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tractus::sim {

// A serial port emulated by a pseudo-terminal: a program that opens its node reads what is sent,
// through the same system calls as from a board on a real port. It needs no privileges, and
// disappears with this object.
class PtySerialPort final : public KernelDevice {
public:
    // Creates the port. `link`, unless empty, is a symbolic link to the node, as udev makes them
    // for boards; it replaces a link that points to another pseudo-terminal, and is removed with
    // the port. Fails with a user error if there are no pseudo-terminals, or if the link cannot
    // be made.
    static Result<std::unique_ptr<PtySerialPort>> create(std::filesystem::path link = {});

    ~PtySerialPort() override;
    PtySerialPort(PtySerialPort const&) = delete;
    PtySerialPort& operator=(PtySerialPort const&) = delete;

    // Returns the address to open, such as /dev/pts/3: the link, if there is one.
    std::string address() const { return link_.empty() ? node_ : link_.string(); }

    // Adds no file: a pseudo-terminal does not announce its readers, so that serve() has to be
    // called from time to time.
    void add_files_to(std::vector<pollfd>&) const override { }

    // Notices readers, and discards what they write.
    Result<void> serve() override;

    // Sends bytes. They are dropped if nobody reads the port, or if the kernel's buffer is full.
    Result<void> send(std::span<std::byte const> bytes) override;

    bool is_read() const override { return is_read_; }
    bool detects_readers_by_reports() const override { return false; }
    std::uint64_t lost_count() const override { return lost_; }
    std::size_t waiting_count() const override { return 0; }

private:
    PtySerialPort(FileDescriptor file, std::string node)
        : file_(std::move(file))
        , node_(std::move(node))
    {
    }

    FileDescriptor file_; // The board's end of the pseudo-terminal.
    std::string node_;    // Path of the station's end, such as /dev/pts/3.
    std::filesystem::path link_ {};
    bool is_read_ = false;
    bool was_read_ = false; // True once a program has opened the station's end.
    std::uint64_t lost_ = 0;
};

} // namespace tractus::sim
