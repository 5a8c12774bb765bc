#pragma once

#include <memory>
#include <optional>

namespace tractus::terminal {

// Reads single keys from standard input. On a terminal they arrive without Enter and without echo
// until this object is destroyed; signals such as Ctrl-C keep working. Pipes and files are read by
// characters.
class TerminalKeys {
public:
    TerminalKeys();
    ~TerminalKeys();
    TerminalKeys(TerminalKeys const&) = delete;
    TerminalKeys& operator=(TerminalKeys const&) = delete;

    // The next key, or no value if none is waiting. Does not wait. After the end of input it keeps
    // returning '\4'.
    std::optional<char> read();

    bool is_terminal() const;

private:
    struct Before;
    // Settings of the terminal to restore; null if input is not a terminal.
    std::unique_ptr<Before> before_;
};

} // namespace tractus::terminal
