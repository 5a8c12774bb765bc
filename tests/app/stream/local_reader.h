#pragma once

#include <array>
#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace tractus::stream {

// A client of a local socket that runs in the test's own thread. That works because the socket's
// buffer accepts data before they are read.
class LocalReader {
public:
    explicit LocalReader(std::filesystem::path const& path)
        : socket_(::socket(AF_UNIX, SOCK_STREAM, 0))
    {
        sockaddr_un address {};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr const*>(&address), sizeof address),
                  0);
    }
    ~LocalReader() { leave(); }
    LocalReader(LocalReader const&) = delete;
    LocalReader& operator=(LocalReader const&) = delete;

    // Returns the data that can be read now; empty if there are none.
    std::string read_now() const
    {
        std::string text;
        std::array<char, 65536> part {};
        for (ssize_t count = 1; count > 0;) {
            count = ::recv(socket_, part.data(), part.size(), MSG_DONTWAIT);
            if (count > 0)
                text.append(part.data(), static_cast<std::size_t>(count));
        }
        return text;
    }

    // Closes the writing end, like a pipe of a shell whose input has ended.
    void close_writing() const { ::shutdown(socket_, SHUT_WR); }

    void leave()
    {
        if (socket_ >= 0)
            ::close(socket_);
        socket_ = -1;
    }

private:
    int socket_;
};

// Fixture with its own path for a socket.
class SocketPlace : public testing::Test {
protected:
    void SetUp() override { std::filesystem::remove(path_); }
    void TearDown() override { std::filesystem::remove(path_); }

    std::filesystem::path path_
        = std::filesystem::temp_directory_path() / ("tractus_stream_" + std::to_string(::getpid()));
};

} // namespace tractus::stream
