// SPDX-License-Identifier: MIT
#include "behavior/surface/NarrowWays.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace crowd::behavior {

namespace {

constexpr std::size_t kLeastNarrow = 6; ///< cells: less is the corner of a room

/// The cells of a height field, by their spans.
class Cells
{
public:
    explicit Cells(const rcCompactHeightfield& field)
        : m_field(field), m_at(static_cast<std::size_t>(field.spanCount))
    {
        for (int cell = 0; cell < field.width * field.height; ++cell) {
            for (unsigned i = 0; i < field.cells[cell].count; ++i) {
                m_at[field.cells[cell].index + i] = cell;
            }
        }
    }
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// The eight spans about one that are on its level, in their order; kNone where there is none.
    [[nodiscard]] std::array<std::size_t, 8> ring(std::size_t span) const
    {
        std::array<std::size_t, 8> found{};
        for (int side = 0; side < 4; ++side) {
            const int next = (side + 1) & 3;
            const std::size_t straight = beside(span, side);
            const auto at = static_cast<std::size_t>(side) * 2;
            found[at] = straight;
            found[at + 1] = straight == kNone ? kNone : beside(straight, next);
            if (found[at + 1] == kNone) {
                const std::size_t other = beside(span, next);
                found[at + 1] = other == kNone ? kNone : beside(other, side);
            }
        }
        return found;
    }

private:
    [[nodiscard]] std::size_t beside(std::size_t span, int side) const
    {
        const int level = rcGetCon(m_field.spans[span], side);
        if (level == RC_NOT_CONNECTED) {
            return kNone;
        }
        const int cell = m_at[span] + rcGetDirOffsetX(side) + rcGetDirOffsetY(side) * m_field.width;
        return m_field.cells[cell].index + static_cast<unsigned>(level);
    }

    const rcCompactHeightfield& m_field;
    std::vector<int> m_at; ///< its cell, by span
};

using Marks = std::vector<unsigned char>; ///< by span: 0 or an area

/// Also what is within so many cells, of `among`.
Marks grown(const Cells& cells, const Marks& from, const Marks& among, int steps)
{
    Marks marks = from;
    std::vector<std::size_t> front;
    for (std::size_t span = 0; span < from.size(); ++span) {
        if (from[span] != RC_NULL_AREA) {
            front.push_back(span);
        }
    }
    for (int step = 0; step < steps; ++step) {
        std::vector<std::size_t> next;
        for (const std::size_t span : front) {
            for (const std::size_t beside : cells.ring(span)) {
                if (beside != Cells::kNone && marks[beside] == RC_NULL_AREA &&
                    among[beside] != RC_NULL_AREA) {
                    marks[beside] = among[beside];
                    next.push_back(beside);
                }
            }
        }
        front = std::move(next);
    }
    return marks;
}

/// Takes away what hangs together in fewer cells than a way has.
void dropCrumbs(const Cells& cells, Marks& marks)
{
    std::vector<char> isSeen(marks.size(), 0);
    for (std::size_t first = 0; first < marks.size(); ++first) {
        if (marks[first] == RC_NULL_AREA || isSeen[first] != 0) {
            continue;
        }
        std::vector<std::size_t> piece{first};
        isSeen[first] = 1;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            for (const std::size_t beside : cells.ring(piece[i])) {
                if (beside != Cells::kNone && marks[beside] != RC_NULL_AREA &&
                    isSeen[beside] == 0) {
                    isSeen[beside] = 1;
                    piece.push_back(beside);
                }
            }
        }
        if (piece.size() < kLeastNarrow) {
            for (const std::size_t span : piece) {
                marks[span] = RC_NULL_AREA;
            }
        }
    }
}

/// Whether what hangs together about a cell does so without it: Yokoi's number for neighbours that
/// share a side (S. Yokoi, J. Toriwaki, T. Fukumura, 1975) is 1.
bool isSpare(const Cells& cells, const Marks& marks, std::size_t span)
{
    const std::array<std::size_t, 8> ring = cells.ring(span);
    const auto is = [&](std::size_t i) {
        return ring[i & 7] != Cells::kNone && marks[ring[i & 7]] != RC_NULL_AREA ? 1 : 0;
    };
    int number = 0;
    for (std::size_t i = 0; i < 8; i += 2) {
        number += is(i) - is(i) * is(i + 1) * is(i + 2);
    }
    return number == 1;
}

/// The lines by which pieces of `kept` hang together through `among`: what is left when all else is
/// taken away from its edges inwards. A door whose posts both sides nearly touch is such a line.
Marks thinned(const Cells& cells, const Marks& kept, const Marks& among)
{
    Marks marks = among;
    std::vector<std::size_t> spans;
    const auto isEdge = [&](std::size_t span) {
        return std::ranges::any_of(cells.ring(span), [&](std::size_t beside) {
            return beside == Cells::kNone || marks[beside] == RC_NULL_AREA;
        });
    };
    for (std::size_t span = 0; span < marks.size(); ++span) {
        if (among[span] != RC_NULL_AREA && kept[span] == RC_NULL_AREA) {
            spans.push_back(span);
        }
    }
    for (bool isDone = false; !isDone;) {
        std::vector<std::size_t> edge;
        std::ranges::copy_if(spans, std::back_inserter(edge), isEdge);
        const auto takesAway = [&](std::size_t span) {
            if (!isSpare(cells, marks, span)) {
                return false;
            }
            marks[span] = RC_NULL_AREA;
            return true;
        };
        isDone = std::ranges::count_if(edge, takesAway) == 0;
        std::erase_if(spans, [&](std::size_t span) { return marks[span] == RC_NULL_AREA; });
    }
    return marks;
}

} // namespace

bool erodeForBodies(rcContext& context, const BodyCells& body, rcCompactHeightfield& field)
{
    const Marks open(field.areas, field.areas + field.spanCount);
    if (body.radius > 0 && !rcErodeWalkableArea(&context, body.radius, field)) {
        return false;
    }
    if (body.narrowest >= body.radius) {
        return true;
    }
    const Marks whole(field.areas, field.areas + field.spanCount);
    std::ranges::copy(open, field.areas);
    if (body.narrowest > 0 && !rcErodeWalkableArea(&context, body.narrowest, field)) {
        return false;
    }
    const Marks slim(field.areas, field.areas + field.spanCount);
    const Cells cells(field);
    const int slimmer = body.radius - body.narrowest;
    const Marks covered = grown(cells, whole, slim, slimmer + 1);
    Marks narrow = slim;
    for (std::size_t span = 0; span < narrow.size(); ++span) {
        if (covered[span] != RC_NULL_AREA) {
            narrow[span] = RC_NULL_AREA;
        }
    }
    dropCrumbs(cells, narrow);
    Marks kept = grown(cells, narrow, slim, slimmer + 2); // as far as where there is room
    for (std::size_t span = 0; span < whole.size(); ++span) {
        kept[span] = whole[span] != RC_NULL_AREA ? whole[span] : kept[span];
    }
    Marks doors = thinned(cells, kept, slim);
    for (std::size_t span = 0; span < doors.size(); ++span) {
        doors[span] = kept[span] != RC_NULL_AREA ? RC_NULL_AREA : doors[span];
    }
    const Marks wide = grown(cells, doors, slim, 1);
    for (std::size_t span = 0; span < kept.size(); ++span) {
        field.areas[span] = kept[span] != RC_NULL_AREA ? kept[span] : wide[span];
    }
    return true;
}

} // namespace crowd::behavior
