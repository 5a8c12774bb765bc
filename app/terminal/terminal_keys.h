#pragma once

#include <memory>
#include <optional>

namespace tractus::terminal {

// Keys as they are pressed, from standard input. At a terminal they come without waiting for Enter
// and are not echoed, until this is destroyed; signals like Ctrl-C work as ever. From a pipe or a
// file they are its characters.
class TerminalKeys {
public:
    TerminalKeys();
    ~TerminalKeys();
    TerminalKeys(TerminalKeys const&) = delete;
    TerminalKeys& operator=(TerminalKeys const&) = delete;

    // Does not wait. No value: none now. The input's end is '\4', again and again.
    std::optional<char> read();

    bool is_terminal() const;

private:
    struct Before;
    std::unique_ptr<Before> before_; // How the terminal was; null if it is none.
};

} // namespace tractus::terminal
