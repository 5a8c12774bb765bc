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

// The roles that kinds of modules have in a search for neighbours.
struct NeighbourRoles {
    // Role of a kind: an ordinary module, one that contexts ignore, or an opening or closing
    // bracket.
    enum class Role : std::uint8_t { Seen, Ignored, Opening, Closing };

    std::array<Role, 256> of_kind {};
    KindId none = 0;           // Value that represents a missing neighbour.
    bool sees_branches = true; // True if right contexts see brackets as the limits of branches.
};

// A piece of a string in a parallel search for the neighbours of all modules. While the piece is
// scanned, neighbours outside it are unknown; placeholders represent them until join_neighbours()
// resolves these. Pieces can therefore be scanned at the same time.
class PieceNeighbours {
public:
    // Writes the right neighbours of the piece's modules, `begin` to `end` of the string, to
    // `rights`, which has an entry for each module of the string. Right neighbours after the piece
    // are left open.
    void read(NeighbourRoles const& roles, KindId const* string, std::size_t begin, std::size_t end,
              KindId* rights);

    // Writes the right neighbours that lie after the piece. Call it after join_neighbours().
    void write_missing(KindId* rights) const;

    // Returns the left neighbour of the piece's first module; valid after join_neighbours().
    KindId left() const { return left_; }
    // Returns the left neighbours of the modules after those branches that begin before the piece
    // and end in it. The last entry is for the branch that ends first. There are fewer entries if
    // brackets do not match.
    std::vector<KindId> const& waiting_lefts() const { return waiting_lefts_; }

private:
    template<bool kSeesBranches>
    void read_all(NeighbourRoles const& roles, KindId const* string, std::size_t begin,
                  std::size_t end, KindId* rights);

    friend void join_neighbours(NeighbourRoles const& roles, std::span<PieceNeighbours> pieces);

    // A kind; or a placeholder kOutside + i for the right neighbour at the piece's end (i = 0) or
    // after the end of the i-th branch that is open there, counted outwards.
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

    // Modules whose right neighbours lie after the piece, in right-to-left order.
    std::vector<Missing> missing_;
    // Right neighbour of the last module before the piece; may be a placeholder.
    Neighbour right_ = 0;
    // For each branch that begins before the piece and ends in it, the right neighbour of the
    // module before the branch.
    Column<Neighbour> waiting_;
    std::size_t taken_count_ = 0; // Number of branches that begin in the piece and end after it.
    std::vector<KindId> outside_; // Resolved values of the placeholders kOutside + i.
    // Left neighbours at the end of the piece, and before each of the branches that begin in the
    // piece and end after it, from the last branch to the first. An entry without a value equals
    // the next entry.
    std::vector<std::optional<KindId>> lefts_;
    std::size_t closing_count_ = 0; // Number of branches that begin before the piece and end in it.
    KindId left_ = 0;
    std::vector<KindId> waiting_lefts_;
};

// Passes neighbours from piece to piece of the string, in both directions, so that all become
// known.
void join_neighbours(NeighbourRoles const& roles, std::span<PieceNeighbours> pieces);

} // namespace tractus::lsystem
