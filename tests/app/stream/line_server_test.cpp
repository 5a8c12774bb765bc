#include "app/stream/line_server.h"

#include "tests/app/stream/local_reader.h"

#include <algorithm>
#include <fstream>
#include <list>
#include <sys/stat.h>

namespace tractus::stream {
namespace {

constexpr auto kKeep = LineServer::Importance::Keep;
constexpr auto kLeaveOut = LineServer::Importance::LeaveOut;

class LineServerTest : public SocketPlace {
protected:
    LineServer listen() const { return LineServer::listen(path_, "hello\n").value(); }
};

TEST_F(LineServerTest, GivesAllReadersTheSameLinesFromWhenTheyCame)
{
    auto server = listen();
    LocalReader const first(path_);
    server.serve({});
    server.publish("one\n", kKeep);
    server.serve({});
    LocalReader const second(path_);
    server.serve({});
    server.publish("two\n", kLeaveOut);
    server.serve({});
    EXPECT_EQ(server.reader_count(), 2u);
    EXPECT_EQ(first.read_now(), "hello\none\ntwo\n");
    EXPECT_EQ(second.read_now(), "hello\ntwo\n");
}

TEST_F(LineServerTest, ForgetsAReaderThatHasGone)
{
    auto server = listen();
    LocalReader reader(path_);
    server.serve({});
    ASSERT_EQ(server.reader_count(), 1u);
    reader.leave();
    server.publish("one\n", kKeep);
    server.serve({}); // The reader's end of the socket is closed. SIGPIPE would end the test.
    EXPECT_EQ(server.reader_count(), 0u);
}

TEST_F(LineServerTest, ForgetsAReaderThatHasGoneWhileThereWasNothingToSay)
{
    auto server = listen();
    LocalReader reader(path_);
    server.serve({});
    reader.leave();
    server.serve({});
    EXPECT_EQ(server.reader_count(), 0u);
}

TEST_F(LineServerTest, KeepsAReaderThatOnlyHasNothingToSay)
{
    auto server = listen();
    LocalReader const reader(path_);
    reader.close_writing();
    server.serve({});
    server.publish("one\n", kKeep);
    server.serve({});
    EXPECT_EQ(reader.read_now(), "hello\none\n");
}

// Returns everything that the reader receives while the server sends.
std::string read_all(LineServer& server, LocalReader const& reader)
{
    std::string text;
    for (std::string part = "-"; !part.empty();) {
        server.serve({});
        part = reader.read_now();
        text += part;
    }
    return text;
}

TEST_F(LineServerTest, LeavesOutForASlowReaderWhatMayBeLeftOutAndSaysSo)
{
    auto server = listen();
    LocalReader const reader(path_);
    server.serve({});
    std::string const line(999, 'x');
    // The lines have 5 MB in total; the reader reads nothing until all are published.
    constexpr std::size_t kCount = 5000;
    for (std::size_t i = 0; i < kCount; ++i) {
        server.publish(line + "\n", kLeaveOut);
        server.serve({});
    }
    server.publish("stroke\n", kKeep);
    auto const text = read_all(server, reader);
    auto const lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    // Besides these lines, the reader receives "hello", the report of the loss, and "stroke".
    auto const lost = kCount - (lines - 3);
    EXPECT_GT(lost, 0u);
    EXPECT_GT(lines * 1000, LineServer::kMaxWaiting);
    auto const end = "{\"type\":\"lost\",\"tips\":" + std::to_string(lost) + "}\nstroke\n";
    EXPECT_EQ(text.substr(text.size() - end.size()), end);
}

TEST_F(LineServerTest, CutsOffWhoDoesNotReadAtAllAndGoesOnForOthers)
{
    auto server = listen();
    LocalReader const stuck(path_);
    LocalReader const other(path_);
    server.serve({});
    std::string const stroke = std::string((1 << 20) - 1, 'x') + "\n";
    std::size_t read = 0;
    for (int i = 0; i < 70; ++i) {
        server.publish(stroke, kKeep);
        read += read_all(server, other).size();
    }
    EXPECT_EQ(server.reader_count(), 1u);
    EXPECT_GT(read, LineServer::kMaxKept);
}

TEST_F(LineServerTest, DoesNotCountWhatWaitsForAReaderThatTakesNothing)
{
    auto server = listen();
    LocalReader const stuck(path_);
    LocalReader const other(path_);
    Timestamp now = timestamp_ns(1'000'000'000);
    server.serve(now);
    // The line is longer than the buffer of a socket.
    std::string const line(std::size_t { 1 } << 20, 'x');
    server.publish(line, kKeep);
    server.serve(now);
    auto const waiting = server.waiting_bytes();
    EXPECT_GT(waiting, 0u);
    now += LineServer::kPatience;
    std::size_t read = 0;
    while (read < line.size()) {
        server.serve(now);
        read += other.read_now().size();
    }
    EXPECT_EQ(server.waiting_bytes(), 0u);
    EXPECT_EQ(server.reader_count(), 2u);
    // When the reader that was stuck reads again, it must receive everything.
    auto const late = stuck.read_now();
    server.serve(now);
    EXPECT_GT(server.waiting_bytes(), 0u);
    std::string rest;
    for (std::string part = "-"; !part.empty();) {
        part = stuck.read_now();
        server.serve(now);
        rest += part;
    }
    EXPECT_EQ(late.size() + rest.size(), line.size() + std::string("hello\n").size());
}

TEST_F(LineServerTest, TakesNoMoreReadersThanItSays)
{
    auto server = listen();
    std::list<LocalReader> readers;
    for (std::size_t i = 0; i < LineServer::kMaxReaders + 3; ++i) {
        readers.emplace_back(path_);
        server.serve({});
    }
    EXPECT_EQ(server.reader_count(), LineServer::kMaxReaders);
    readers.pop_front();
    server.serve({});
    server.serve({});
    EXPECT_EQ(server.reader_count(), LineServer::kMaxReaders);
}

TEST_F(LineServerTest, IsItsOwnersAlone)
{
    auto const server = listen();
    struct stat there { };
    ASSERT_EQ(::stat(path_.c_str(), &there), 0);
    EXPECT_EQ(there.st_mode & 0777, 0600u);
}

TEST_F(LineServerTest, TakesItsNameAwayAndThePlaceOfOneThatDidNot)
{
    {
        auto const server = listen();
        EXPECT_TRUE(std::filesystem::exists(path_));
    }
    EXPECT_FALSE(std::filesystem::exists(path_));
    int const dead = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address {};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(dead, reinterpret_cast<sockaddr const*>(&address), sizeof address), 0);
    ::close(dead);
    ASSERT_TRUE(std::filesystem::exists(path_));
    auto const server = LineServer::listen(path_, "");
    EXPECT_TRUE(server) << server.error().message;
}

TEST_F(LineServerTest, RefusesAPlaceThatIsTaken)
{
    auto const first = listen();
    EXPECT_EQ(LineServer::listen(path_, "").error().message,
              "another program streams at " + path_.string() + ": choose another name");
    EXPECT_TRUE(std::filesystem::exists(path_));
    auto const file = path_.string() + ".txt";
    std::ofstream(file) << "mine";
    EXPECT_EQ(LineServer::listen(file, "").error().message,
              file + " is there already, and is no socket: choose another name");
    EXPECT_EQ(std::filesystem::file_size(file), 4u);
    std::filesystem::remove(file);
    std::string const longest(108, 'a');
    EXPECT_EQ(LineServer::listen(longest, "").error().message,
              longest
                  + ": a socket's name has 1 to 107 bytes, and this one 108: choose another place");
}

} // namespace
} // namespace tractus::stream
