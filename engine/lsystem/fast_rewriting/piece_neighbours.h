#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lsystem {

// What kinds of modules are to their neighbours.
struct NeighbourRoles {
    // In a row of modules that all are seen, the neighbours are those next to it.
    enum class Role : std::uint8_t { Seen, Ignored, Opening, Closing };

    std::array<Role, 256> of_kind {};
    KindId none = 0;           // Stands for "no neighbour".
    bool sees_branches = true; // Right contexts see branches.
};

// A piece of a string, and what passes its ends while neighbours are looked for: the neighbour that
// is looked at, and a stack of those that wait for their branches' ends. A piece is read before
// what comes to it from outside is known, and says then what it makes of that; so pieces can be
// read at the same time.
class PieceNeighbours {
public:
    // Writes the right neighbours of modules `begin` to `end` of the string, the piece, but for
    // those that stand behind it. `rights` has as many places as the string.
    void read(NeighbourRoles const& roles, KindId const* string, std::size_t begin, std::size_t end,
              KindId* rights);

    // Writes those that stand behind it, after join_neighbours().
    void write_missing(KindId* rights) const;

    // The left neighbour of the piece's first module, after join_neighbours().
    KindId left() const { return left_; }
    // Left neighbours for what follows the branches that end in the piece and begin before it; the
    // last is for the first to end. There are fewer where brackets do not match.
    std::vector<KindId> const& waiting_lefts() const { return waiting_lefts_; }

private:
    template<bool kSeesBranches>
    void read_all(NeighbourRoles const& roles, KindId const* string, std::size_t begin,
                  std::size_t end, KindId* rights);

    friend void join_neighbours(NeighbourRoles const& roles, std::span<PieceNeighbours> pieces);

    // A kind; or kOutside + i: what stands i branches outside of the piece's last module.
    using Neighbour = std::uint32_t;
    static constexpr Neighbour kOutside = 256;

    struct Missing {
        std::size_t module = 0;
        std::size_t outside = 0;
    };

    KindId value(Neighbour neighbour) const
    {
        return static_cast<KindId>(neighbour < kOutside ? neighbour
                                                        : outside_[neighbour - kOutside]);
    }
    void take_from_right(NeighbourRoles const& roles, KindId& right, std::vector<KindId>& waiting);
    void take_from_left(NeighbourRoles const& roles, KindId& left, std::vector<KindId>& waiting);

    // Read from the right.
    std::vector<Missing> missing_;
    Neighbour right_ = 0;         // For the module before the piece.
    Column<Neighbour> waiting_;   // Of branches that end in the piece and begin before it.
    std::size_t taken_count_ = 0; // Branches that begin in the piece and end behind it.
    std::vector<KindId> outside_; // What kOutside + i stands for.
    // What those from the left will be at the piece's end, and before each of the branches that
    // begin in it and end behind it, from the last to the first. No value: as the next.
    std::vector<std::optional<KindId>> lefts_;
    std::size_t closing_count_ = 0; // Branches that end in the piece and begin before it.
    KindId left_ = 0;
    std::vector<KindId> waiting_lefts_;
};

// Tells each of the string's pieces, in their order, what comes to it from outside.
void join_neighbours(NeighbourRoles const& roles, std::span<PieceNeighbours> pieces);

} // namespace tractus::lsystem
