#pragma once

#include <memory>
#include <optional>

namespace tractus::terminal {

// Reads single keys from standard input. Until this object is destroyed, a terminal delivers keys
// without Enter and without echo; signals such as Ctrl-C keep working. Pipes and files are read
// character by character.
class TerminalKeys {
public:
    TerminalKeys();
    ~TerminalKeys();
    TerminalKeys(TerminalKeys const&) = delete;
    TerminalKeys& operator=(TerminalKeys const&) = delete;

    // Returns the next key, or no value if none is waiting. Does not block. After the end of input,
    // each call returns '\4'.
    std::optional<char> read();

    bool is_terminal() const;

private:
    struct Before;
    // Settings of the terminal before this object changed them; null if input is not a terminal.
    std::unique_ptr<Before> before_;
};

} // namespace tractus::terminal
