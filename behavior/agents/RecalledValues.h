// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "behavior/agents/PropertyOverrides.h"
#include "model/population/ColumnSet.h"

namespace crowd::behavior {

/// What states that were recalled in a session alone have made of people: values that differ from
/// the scene's. One thread.
class RecalledValues
{
public:
    /// Null: none. Immutable; may be read on any thread.
    [[nodiscard]] const std::shared_ptr<const OverrideColumns>& columns() const
    {
        return m_columns;
    }
    /// The scene's people with these values.
    [[nodiscard]] model::Population over(const model::Population& scene) const;
    /// From now on it is the values of these columns in which `now` differs from the scene: the
    /// same people.
    void take(const model::Population& scene, const model::Population& now,
              model::ColumnSet columns);
    /// Where an edit has given somebody another value, the scene counts again.
    void forgetEdited(const model::Population& before, const model::Population& now);

private:
    void put(OverrideColumns columns);

    std::shared_ptr<const OverrideColumns> m_columns;
};

/// Writes all of them; ids that are not there are passed over.
void writeColumns(const OverrideColumns& columns, model::Population& people);

} // namespace crowd::behavior
