// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <QtCore/QString>
#include <QtGui/QColor>

#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// A tag that somebody in the picture has.
struct TagLabel
{
    QString name;
    QColor color;
    friend bool operator==(const TagLabel&, const TagLabel&) = default;
};

/// Whether tags are seen: as the view is set, and always while a brush works on them.
[[nodiscard]] bool showsTags(const EditorState& state);

/// What is drawn under people, of a frame: a ring in the colours of their tags, shared evenly by
/// several, and a disc where a rule has just fired.
class PeopleMarks
{
public:
    void make(const EditorState& state, const model::CrowdFrame& frame);
    void add(std::span<const render::Marker> others);
    [[nodiscard]] std::span<const render::Marker> markers() const { return m_markers; }
    /// Of the rings, by bit.
    [[nodiscard]] const std::vector<TagLabel>& legend() const { return m_legend; }

private:
    void addRing(const glm::vec3& position, std::uint64_t tags, std::span<const glm::vec4> colors);

    std::vector<render::Marker> m_markers;
    std::vector<TagLabel> m_legend;
};

} // namespace crowd::widgets
