// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <QtCore/QObject>

#include "model/document/SceneDocument.h"
#include "model/scene/SceneChange.h"

namespace crowd::widgets {

/// How new ids meet those that are selected already.
enum class SelectionMode : unsigned char { Replace, Add, Toggle };

/// The selected individuals, by id. Follows the document: ids that vanish are dropped, and are
/// selected again when undo brings them back before anybody else is selected; those whose group is
/// hidden or locked are never among them. Selecting is not an edit and cannot be undone. Main
/// thread only; the document outlives it.
class Selection : public QObject
{
    Q_OBJECT

public:
    explicit Selection(model::SceneDocument& document, QObject* parent = nullptr);

    [[nodiscard]] std::span<const model::IndividualId> ids() const { return m_ids; } ///< ascending
    [[nodiscard]] bool isEmpty() const { return m_ids.empty(); }
    [[nodiscard]] std::size_t size() const { return m_ids.size(); }
    [[nodiscard]] bool contains(model::IndividualId id) const;

    /// Ids in any order; those that the scene does not have are left out.
    void apply(std::span<const model::IndividualId> ids, SelectionMode mode);
    void set(std::span<const model::IndividualId> ids) { apply(ids, SelectionMode::Replace); }
    void selectAll();
    void invert();
    void clear() { apply({}, SelectionMode::Replace); }

Q_SIGNALS:
    void changed();

private:
    /// Those of them that may be touched.
    void replace(std::vector<model::IndividualId> ids);
    void follow(const model::SceneChange& change);
    /// Deleted while they were selected, and there again.
    [[nodiscard]] std::vector<model::IndividualId> takeBack();

    model::SceneDocument& m_document;
    std::vector<model::IndividualId> m_ids;
    std::vector<model::IndividualId> m_gone; ///< ascending
};

} // namespace crowd::widgets
