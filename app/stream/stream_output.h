#pragma once

#include "app/station/station.h"
#include "app/stream/line_server.h"
#include "app/tools/tool.h"
#include "engine/base/result.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::stream {

// Where lines of a stream go: standard output, which waits for its reader, or a local socket, which
// does not (line_server.h).
class StreamOutput {
public:
    // Parts of a drawing that are told.
    enum class What { All, Strokes };

    // `write` takes the lines, as print_out() does, and fails as it does.
    using Write = std::function<Result<void>(std::string_view line)>;
    static Result<StreamOutput> open(Write write, Bounds const& volume_mm, What what);

    // Fails like LineServer::listen().
    static Result<StreamOutput> open_socket(std::filesystem::path const& path,
                                            Bounds const& volume_mm, What what);

    // Takes what the station has done since it was taken last, in the order in which it was done.
    // What grows along strokes grows in `scene`. Fails as `write` does.
    Result<void> take(station::Station& station, scene::Scene const& scene);

    // Tells what the station has done, whose moments were taken already. Strokes are left to
    // somebody else, who takes them before the next call.
    Result<void> tell(std::span<station::PenMoment const> moments, station::Station const& station,
                      scene::Scene const& scene);

    // Lets readers of the socket in and gives them what they take now: see LineServer::serve().
    void serve(Timestamp now);

    // Says that the stream is over. Fails as `write` does.
    Result<void> end();

    // Whether there is nobody to read: of a socket at which nobody has called.
    bool has_readers() const { return !server_ || server_->reader_count() > 0; }

    // Bytes that wait for readers: see LineServer::waiting_bytes().
    std::size_t waiting_bytes() const { return server_ ? server_->waiting_bytes() : 0; }

private:
    StreamOutput(Write write, std::optional<LineServer> server, What what);

    // A stroke along which something grows, by the time of its first tip.
    struct Growing {
        Timestamp began {};
        std::size_t steps_told = 0;
        std::size_t tips = 0; // That it had then.
    };

    Result<void> tell_steps(Stroke const& stroke, tools::Tool const& tool,
                            scene::Scene const& scene);
    Result<void> put(std::string const& line, LineServer::Importance importance);

    Write write_;
    std::optional<LineServer> server_;
    What what_;
    std::size_t stroke_count_ = 0;
    std::vector<Growing> growing_; // Those under way, one for each pen.
};

} // namespace tractus::stream
