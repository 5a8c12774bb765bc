#include "engine/export/glb_writer.h"

#include "engine/base/parallel.h"
#include "engine/export/compressed_piece.h"
#include "engine/export/glb_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::exports {
namespace {

constexpr std::size_t kInstancesAtOnce = 16 << 10;
// All plants are expected to have at least this share of the first plant's size in bytes.
constexpr double kLikelyShare = 0.8;

std::unique_ptr<MeshPieces const> pieces_for(MeshSource const& source, GlbOptions const& options)
{
    return std::make_unique<MeshPieces>(
        source,
        options.organs == GlbOptions::Organs::Merged ? MeshPieces::Organs::Merged
                                                     : MeshPieces::Organs::Apart,
        options.textures == GlbOptions::Textures::Embedded ? MeshPieces::Tangents::ForRelief
                                                           : MeshPieces::Tangents::Never,
        options.vertices == GlbOptions::Vertices::Compressed ? MeshPieces::Cut::OwnMeshes
                                                             : MeshPieces::Cut::OneSurface);
}

// A level of a plant that is being written. The units of work for its pieces share it, and the last
// of them frees it, so that plants already written take no memory.
struct PlantOnItsWay {
    LevelInFile level;
    std::unique_ptr<MeshPieces const> pieces;
    PlantFormat format {};
};

// A unit of work: a piece of a surface, some of an organ's instances, or the end of a level.
struct Unit {
    enum class Kind { Surface, Organ, End };

    Kind kind = Kind::End;
    std::shared_ptr<PlantOnItsWay const> plant {};
    std::size_t index = 0; // Index of the surface or organ in the plant's MeshPieces.
    std::size_t piece = 0;
    std::size_t piece_count = 0;
    bool begins_level = false;

    // Memory for the unit's data, which is reused for one unit after another.
    MeshPieces::Buffer buffer {};
    std::vector<mesh::WindVertex> wind {};
    EncodedPiece encoded {};

    bool is_last() const { return piece + 1 == piece_count; }
};

// Lists the units of work of all plants, in the order of the file. Each plant is grown and planned
// only when its first unit is needed.
class Units {
public:
    // `first`: the pieces of the first plant's finest level, if they have been made already;
    // otherwise null.
    Units(std::span<PlacedMesh const> plants, GlbOptions const& options,
          std::unique_ptr<MeshPieces const> first)
        : plants_(plants)
        , options_(options)
        , first_(std::move(first))
    {
    }

    bool next(Unit& unit)
    {
        unit.begins_level = !plant_;
        if (!plant_ && !begin_level())
            return false;
        while (piece_ == piece_count() && kind_ != Unit::Kind::End)
            advance();
        unit.kind = kind_;
        unit.plant = plant_;
        unit.index = index_;
        unit.piece = piece_++;
        unit.piece_count = piece_count();
        if (kind_ == Unit::Kind::End)
            plant_.reset();
        return true;
    }

private:
    bool begin_level()
    {
        if (taken_ == plants_.size())
            return false;
        auto plant = std::make_shared<PlantOnItsWay>();
        auto const& level = plant->level = { &plants_[taken_], level_++ };
        if (level.is_last()) {
            ++taken_;
            level_ = 0;
        }
        plant->pieces = first_ ? std::move(first_) : pieces_for(level.source(), options_);
        plant->format = plant_format(*plant->pieces, options_);
        plant_ = std::move(plant);
        kind_ = Unit::Kind::Surface;
        index_ = 0;
        piece_ = 0;
        return true;
    }

    // Returns the number of pieces of the current surface or organ; 0 if there is nothing to write.
    std::size_t piece_count() const
    {
        auto const& pieces = *plant_->pieces;
        if (kind_ == Unit::Kind::Surface && index_ < pieces.surfaces().size()) {
            auto const& surface = pieces.surfaces()[index_];
            return surface.extent.indices > 0 ? surface.piece_count : 0;
        }
        if (kind_ == Unit::Kind::Organ && index_ < pieces.organs().size()) {
            auto const& organ = pieces.organs()[index_];
            if (organ.instances.empty() || organ.prototype.indices.empty())
                return 0;
            return options_.organs == GlbOptions::Organs::Nodes
                ? 1
                : (organ.instances.size() + kInstancesAtOnce - 1) / kInstancesAtOnce;
        }
        return 0;
    }

    void advance()
    {
        bool const is_surface = kind_ == Unit::Kind::Surface;
        auto const count
            = is_surface ? plant_->pieces->surfaces().size() : plant_->pieces->organs().size();
        piece_ = 0;
        if (++index_ < count)
            return;
        index_ = 0;
        kind_
            = is_surface && !plant_->pieces->organs().empty() ? Unit::Kind::Organ : Unit::Kind::End;
    }

    std::span<PlacedMesh const> plants_;
    GlbOptions const& options_;
    std::unique_ptr<MeshPieces const> first_;
    std::size_t taken_ = 0;
    std::size_t level_ = 0;
    std::shared_ptr<PlantOnItsWay const> plant_;
    Unit::Kind kind_ = Unit::Kind::End;
    std::size_t index_ = 0;
    std::size_t piece_ = 0;
};

void encode(Unit& unit, GlbOptions const& options)
{
    auto const& plant = *unit.plant;
    bool const compressed = options.vertices == GlbOptions::Vertices::Compressed;
    if (unit.kind == Unit::Kind::Surface) {
        auto const& surface = plant.pieces->surfaces()[unit.index];
        auto const format = plant.format.of(*plant.pieces, surface);
        encode_triangles(plant.pieces->piece(unit.index, unit.piece, unit.buffer), format,
                         unit.encoded);
        plant.pieces->wind(unit.index, unit.piece, unit.wind);
        encode_wind(unit.wind, options.wind, unit.encoded);
        if (compressed)
            compress_triangles(format, wind_streams(options.wind), unit.encoded);
    } else if (unit.kind == Unit::Kind::Organ) {
        std::span<mesh::InstanceTransform const> const all
            = plant.pieces->organs()[unit.index].instances;
        auto const first = all.size() * unit.piece / unit.piece_count;
        auto const end = all.size() * (unit.piece + 1) / unit.piece_count;
        encode_instances(all.subspan(first, end - first), plant.format.instances, unit.encoded);
        auto const wind = plant.pieces->organ_wind(unit.index);
        encode_wind(wind.empty() ? wind : wind.subspan(first, end - first),
                    GlbOptions::Wind::Attributes, unit.encoded);
        if (compressed)
            compress_instances(plant.format.instances, unit.encoded);
    }
}

Result<void> write(Unit const& unit, GlbFile& file)
{
    auto const& plant = *unit.plant;
    if (unit.begins_level)
        TRY(file.begin_level(plant.level, *plant.pieces, plant.format));
    switch (unit.kind) {
    case Unit::Kind::Surface:
        return file.add_surface_piece(unit.index, unit.is_last(), unit.encoded);
    case Unit::Kind::Organ:
        return file.add_instances(unit.index, unit.is_last(), unit.encoded);
    case Unit::Kind::End:
        file.end_level();
    }
    return {};
}

// Encodes units of work on all threads, and writes them in order.
Result<void> write_plants(Units units, GlbOptions const& options, GlbFile& file)
{
    std::vector<Unit> slots(static_cast<std::size_t>(thread_count()) + 1);
    Result<void> result;
    parallel_in_order(slots.size(),
                      { .next = [&](std::size_t slot) { return units.next(slots[slot]); },
                        .make = [&](std::size_t slot) { encode(slots[slot], options); },
                        .use =
                            [&](std::size_t slot) {
                                result = write(slots[slot], file);
                                slots[slot].plant.reset();
                                return result.has_value();
                            } });
    return result;
}

// Sizes of the first plant in a file, with all its levels of detail; the other plants are assumed
// to be similar. The pieces of its finest level are kept, since they are written first.
struct FirstPlant {
    std::unique_ptr<MeshPieces const> pieces {};
    std::uint64_t bytes = 0;
    std::uint64_t compressed_bytes = 0; // Size that the plant would have if compressed.
    std::uint64_t json_bytes = 0;
    // Size of the JSON for materials and prototypes, which plants share.
    std::uint64_t shared_json_bytes = 4000;
};

// Returns the number of primitives for surfaces and the number of nodes for instances. If the file
// is compressed, each piece has its own primitive or node.
std::pair<std::size_t, std::size_t> counts_in_json(MeshPieces const& pieces,
                                                   GlbOptions const& options)
{
    if (options.vertices != GlbOptions::Vertices::Compressed)
        return { pieces.surfaces().size(), pieces.organs().size() };
    std::size_t primitives = 0;
    for (auto const& surface : pieces.surfaces())
        primitives += surface.piece_count;
    std::size_t nodes = 0;
    for (auto const& organ : pieces.organs())
        // One of the two is for the prototype.
        nodes += 2 + organ.instances.size() / kInstancesAtOnce;
    return { primitives, nodes };
}

void measure(MeshPieces const& pieces, GlbOptions const& options, FirstPlant& first)
{
    first.bytes += glb_bytes(pieces, options);
    auto compressed = options;
    compressed.vertices = GlbOptions::Vertices::Compressed;
    first.compressed_bytes += glb_bytes(pieces, compressed);
    auto const accessors = pieces.has_wind() ? 10u : 5u;
    auto const [primitives, nodes] = counts_in_json(pieces, options);
    auto const more = options.vertices == GlbOptions::Vertices::Compressed ? 200u : 0u;
    first.json_bytes += 600 + accessors * ((350 + more) * primitives + (250 + more) * nodes);
    if (options.organs == GlbOptions::Organs::Nodes)
        for (auto const& organ : pieces.organs())
            first.json_bytes += (pieces.has_wind() ? 420 : 220) * organ.instances.size();
    if (!pieces.picture_png().empty())
        first.json_bytes += 1000;
    first.shared_json_bytes += 1500 * pieces.organs().size();
}

FirstPlant measure_first(PlacedMesh const& placed, GlbOptions const& options)
{
    FirstPlant first;
    first.pieces = pieces_for(placed.mesh, options);
    measure(*first.pieces, options, first);
    for (auto const& detail : placed.details)
        measure(*pieces_for(detail.mesh, options), options, first);
    return first;
}

// Estimates the size of the JSON from that of the first plant. If the estimate is too small, the
// file is written a second time.
std::uint64_t guess_json_bytes(std::span<PlacedMesh const> plants, FirstPlant const& first)
{
    std::uint64_t bytes = first.shared_json_bytes;
    for (auto const& placed : plants)
        bytes += first.json_bytes + 12 * (1 + placed.details.size()) * placed.name.size();
    return bytes;
}

auto fail_large(std::size_t plants, double bytes, std::string_view about)
{
    return fail(Fault::User,
                fmt::format("these {} plants take {}{:.1f} GiB and a glTF file holds at most 4: "
                            "write fewer plants to a file",
                            plants, about, bytes / 0x1p30));
}

// Fails if the plants are too large for one file. Meshes in memory that will not be compressed are
// measured; all other plants are assumed to be like the first.
Result<void> check_size(std::span<PlacedMesh const> plants, FirstPlant const& first,
                        GlbOptions const& options)
{
    double certain = 0;
    double likely = 0;
    for (auto const& placed : plants)
        if (std::holds_alternative<mesh::Mesh const*>(placed.mesh)
            && options.vertices != GlbOptions::Vertices::Compressed)
            certain += static_cast<double>(glb_bytes(*pieces_for(placed.mesh, options), options));
        else
            likely += static_cast<double>(first.bytes);
    if (certain > static_cast<double>(kMaxGlbBytes))
        return fail_large(plants.size(), certain, "");
    if (certain + kLikelyShare * likely > static_cast<double>(kMaxGlbBytes))
        return fail_large(plants.size(), certain + likely, "about ");
    return {};
}

} // namespace

std::uint64_t glb_bytes(mesh::Mesh const& mesh, GlbOptions const& options)
{
    return glb_bytes(*pieces_for(&mesh, options), options);
}

Result<GlbSummary> write_glb(std::ostream& out, std::span<PlacedMesh const> plants,
                             GlbOptions const& options)
{
    auto const start = out.tellp();
    if (start < 0)
        return fail(Fault::User,
                    "cannot write the glTF file: its stream cannot seek, so write to a file");
    FirstPlant first;
    std::uint64_t room = 200;
    if (!plants.empty()) {
        first = measure_first(plants[0], options);
        TRY(check_size(plants, first, options));
        room = guess_json_bytes(plants, first);
        if (options.before_writing)
            options.before_writing({ .bytes = first.bytes * plants.size(),
                                     .triangles = first.pieces->triangle_count() * plants.size(),
                                     .compressed_bytes = first.compressed_bytes * plants.size() });
    }
    while (true) {
        out.seekp(start);
        GlbFile file(out, options, (room + 3) / 4 * 4);
        TRY(write_plants(Units(plants, options, std::move(first.pieces)), options, file));
        if (auto const summary = TRY(file.finish()))
            return *summary;
        room = file.json_bytes();
    }
}

} // namespace tractus::exports
