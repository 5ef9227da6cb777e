// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene/Scene.h"
#include "widgets/state/Selection.h"

namespace crowd::widgets {

/// Who is selected, grouped by template: clips, slots and choices of several templates are the
/// same when their names are. Looks at the scene while it lives and does not outlast a change of
/// it. Rows are those of the population, in the order of the ids.
class SelectedPeople
{
public:
    struct Group
    {
        const model::TemplateEntry* entry; ///< null: a template that the scene does not have
        std::vector<std::size_t> rows;

        /// -1: these do not have it.
        [[nodiscard]] int slotIndex(const std::string& name) const;
        [[nodiscard]] int choiceIndex(int slot, const std::string& name) const;
        [[nodiscard]] int partIndex(const std::string& name) const;
        [[nodiscard]] int clipIndex(const std::string& name) const; ///< value of the clip column
    };

    SelectedPeople(const model::Scene& scene, const Selection& selection);

    [[nodiscard]] const std::vector<Group>& groups() const { return m_groups; }
    [[nodiscard]] const std::vector<std::size_t>& rows() const { return m_rows; }
    [[nodiscard]] std::vector<model::IndividualId> ids() const;
    [[nodiscard]] std::vector<model::IndividualId> ids(const Group& group) const;

    // Each name once, in the order of the templates.
    [[nodiscard]] std::vector<std::string> clips() const;
    [[nodiscard]] std::vector<std::string> slotNames() const;
    [[nodiscard]] std::vector<std::string> choices(const std::string& slot) const;
    [[nodiscard]] std::vector<std::string> parts() const;
    /// Whether any of them may be tinted there.
    [[nodiscard]] bool isTintable(const std::string& slot) const;

    /// The value that all rows share; get(row).
    template<class T, class Get>
    [[nodiscard]] std::optional<T> common(const Get& get) const
    {
        std::optional<T> shared;
        for (const std::size_t row : m_rows) {
            if (!agree(shared, get(row))) {
                return std::nullopt;
            }
        }
        return shared;
    }
    /// The value that all share who have something: index(group) is -1 for those who do not,
    /// get(row, index) the value.
    template<class T, class Index, class Get>
    [[nodiscard]] std::optional<T> commonOf(const Index& index, const Get& get) const
    {
        std::optional<T> shared;
        for (const Group& group : m_groups) {
            const int at = index(group);
            for (std::size_t i = 0; at >= 0 && i < group.rows.size(); ++i) {
                if (!agree(shared, get(group.rows[i], at))) {
                    return std::nullopt;
                }
            }
        }
        return shared;
    }

private:
    template<class T>
    static bool agree(std::optional<T>& shared, const T& value)
    {
        if (shared && !(*shared == value)) {
            return false;
        }
        shared = value;
        return true;
    }

    const model::Scene& m_scene;
    std::vector<std::size_t> m_rows;
    std::vector<Group> m_groups;
};

} // namespace crowd::widgets
