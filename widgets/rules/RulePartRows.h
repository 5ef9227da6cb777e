// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "model/rules/RuleKind.h"
#include "model/scene/Scene.h"

class QHBoxLayout;
class QVBoxLayout;

/// The fields of one part of a rule as rows of controls, built from their description.
namespace crowd::widgets {

/// Called with a field that the artist has changed. Both live as long as the program.
using FieldChange = std::function<void(const model::FieldInfo&, const model::FieldValue&)>;

/// What the rows are built in.
struct PartRows
{
    const model::Scene& scene;
    QVBoxLayout* layout;
    std::function<QHBoxLayout*()> newRow; ///< adds one to the layout
    FieldChange changed;

    /// Rows of those of the fields that are shown; the last row, or null where there is none.
    QHBoxLayout* add(std::span<const model::FieldInfo> fields, const void* object) const;
    /// One control, with its label before it.
    void addField(QHBoxLayout* row, const model::FieldInfo& field, const void* object) const;

private:
    void addControl(QHBoxLayout* row, const model::FieldInfo& field,
                    const model::FieldValue& value) const;
    void addInteger(QHBoxLayout* row, const model::FieldInfo& field, std::int64_t value) const;
    void addText(QHBoxLayout* row, const model::FieldInfo& field, const std::string& text) const;
};

} // namespace crowd::widgets
