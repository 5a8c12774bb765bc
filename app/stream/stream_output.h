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

// Destination of a stream's lines: either standard output, where writing blocks, or a local socket,
// where it does not (line_server.h).
class StreamOutput {
public:
    // Parts of a drawing that are written: all lines, or strokes only.
    enum class What { All, Strokes };

    // A function that writes a line as print_out() does, and fails like print_out().
    using Write = std::function<Result<void>(std::string_view line)>;
    static Result<StreamOutput> open(Write write, Bounds const& volume_mm, What what);

    // Fails like LineServer::listen().
    static Result<StreamOutput> open_socket(std::filesystem::path const& path,
                                            Bounds const& volume_mm, What what);

    // Takes and writes everything that the station has produced since the last call, in order.
    // `scene` is the scene in which plants grow along strokes. Fails like `write`.
    Result<void> take(station::Station& station, scene::Scene const& scene);

    // Writes pen moments that the caller has taken from the station, and the station's new strokes.
    // The caller must take those strokes from the station before the next call.
    Result<void> tell(std::span<station::PenMoment const> moments, station::Station const& station,
                      scene::Scene const& scene);

    // Accepts readers and sends queued data; see LineServer::serve().
    void serve(Timestamp now);

    // Writes the last line of the stream. Fails like `write`.
    Result<void> end();

    // False for a socket without readers; always true for standard output.
    bool has_readers() const { return !server_ || server_->reader_count() > 0; }

    // Size of the longest queue of a reader in bytes; see LineServer::waiting_bytes().
    std::size_t waiting_bytes() const { return server_ ? server_->waiting_bytes() : 0; }

private:
    StreamOutput(Write write, std::optional<LineServer> server, What what);

    // An unfinished stroke along which a plant grows, identified by the time of its first tip.
    struct Growing {
        Timestamp began {};
        std::size_t reported_steps = 0;
        // Number of the stroke's tips when its growth steps were last written.
        std::size_t tips = 0;
    };

    Result<void> tell_steps(Stroke const& stroke, tools::Tool const& tool,
                            scene::Scene const& scene);
    Result<void> put(std::string const& line, LineServer::Importance importance);

    Write write_;
    std::optional<LineServer> server_;
    What what_;
    std::size_t stroke_count_ = 0;
    // Unfinished strokes along which a plant grows, at most one for each pen.
    std::vector<Growing> growing_;
};

} // namespace tractus::stream
