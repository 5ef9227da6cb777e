// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/population/Columns.h"

namespace crowd::model {

/// Stable id of a kind of relation within its scene; 0 is none.
using RelationKindId = std::uint8_t;

/// That one individual is related to another. Of one kind there is one from one to another at most.
struct Relation
{
    IndividualId from = 0;
    IndividualId to = 0;
    float strength = 1.0F; ///< 0..1
    RelationKindId kind = 0;

    friend bool operator==(const Relation&, const Relation&) = default;
};

/// A relation as one of the two has it.
struct RelationLink
{
    IndividualId other = 0;
    float strength = 1.0F;
    RelationKindId kind = 0;
    bool isOut = true; ///< from this one to the other

    friend bool operator==(const RelationLink&, const RelationLink&) = default;
};

/// What separates two tables; ascending by from, kind and to. One of another strength is in both.
struct RelationDelta
{
    std::vector<Relation> removed;
    std::vector<Relation> added;

    [[nodiscard]] bool isEmpty() const { return removed.empty() && added.empty(); }
    [[nodiscard]] std::size_t bytes() const
    {
        return (removed.size() + added.size()) * sizeof(Relation);
    }
};

/// The relations of a scene, found by individual in constant time. A value: copies share all but
/// what changes after, so that they cost nothing to make. Each copy belongs to one thread at a
/// time; what they share is never written.
class RelationTable
{
public:
    using Delta = RelationDelta;

    [[nodiscard]] bool isEmpty() const { return m_count == 0; }
    [[nodiscard]] std::size_t count() const { return m_count; }
    /// Those of an individual, both ways; ascending by kind and by the other.
    [[nodiscard]] std::span<const RelationLink> of(IndividualId id) const;
    /// Null: there is none.
    [[nodiscard]] const RelationLink* find(IndividualId from, IndividualId to,
                                           RelationKindId kind) const;
    /// All, ascending by from, kind and to.
    [[nodiscard]] std::vector<Relation> all() const;

    /// Adds relations or sets their strength; of several of the same the last one counts. Nobody is
    /// related to himself: such are passed over.
    void put(std::span<const Relation> relations);
    /// Takes those away that there are; strengths are of no account.
    void remove(std::span<const Relation> relations);

    [[nodiscard]] RelationDelta since(const RelationTable& before) const;
    void apply(const RelationDelta& delta, bool isUndo);

    friend bool operator==(const RelationTable& a, const RelationTable& b);

private:
    static constexpr std::size_t kLeafIds = 32;
    static constexpr std::size_t kBranchLeaves = 2048;

    /// The links of 32 individuals, one after the other.
    struct Leaf
    {
        std::array<std::uint32_t, kLeafIds + 1> begins{};
        std::vector<RelationLink> links;

        [[nodiscard]] std::span<const RelationLink> of(std::size_t index) const
        {
            return std::span(links).subspan(begins[index], begins[index + 1] - begins[index]);
        }
    };
    using LeafPtr = std::shared_ptr<const Leaf>;
    /// Those of 65536 individuals; null: they have none.
    using Branch = std::array<LeafPtr, kBranchLeaves>;
    struct LinkEdit
    {
        IndividualId owner = 0;
        RelationLink link;
        bool isGone = false;
    };

    [[nodiscard]] const Leaf* leafOf(std::size_t branch, std::size_t leaf) const;
    void edit(std::span<const Relation> relations, bool isGone);
    [[nodiscard]] LeafPtr edited(const Leaf* before, std::span<const LinkEdit> edits);
    template<class Visit>
    static void forEachDifferent(const RelationTable& a, const RelationTable& b,
                                 const Visit& visit);

    std::vector<std::shared_ptr<const Branch>> m_branches;
    std::size_t m_count = 0;
};

} // namespace crowd::model
