// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QtCore/QString>
#include <QtGui/QColor>

#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// A tag, a group or a value of a feature that somebody in the picture has.
struct TagLabel
{
    QString name;
    QColor color;
    friend bool operator==(const TagLabel&, const TagLabel&) = default;
};

/// Whether tags are seen: as the view is set, and always while a brush works on them.
[[nodiscard]] bool showsTags(const EditorState& state);

/// What is drawn under people, of a frame: a ring in the colours of their tags, shared evenly by
/// several; one of their group, or of the value that they bear, while a brush works on those; and a
/// disc where a rule has just fired.
class PeopleMarks
{
public:
    void make(const EditorState& state, const model::CrowdFrame& frame);
    void add(std::span<const render::Marker> others);
    [[nodiscard]] std::span<const render::Marker> markers() const { return m_markers; }
    /// Of the rings that are seen.
    [[nodiscard]] const std::vector<TagLabel>& legend() const { return m_legend; }

private:
    /// What a ring tells: of a group, or of a value that is borne.
    struct RingLabel
    {
        std::uint32_t id = 0;
        TagLabel shown;
    };

    void addTags(const EditorState& state, const model::CrowdFrame& frame);
    void addRing(const glm::vec3& position, std::uint64_t tags, std::span<const glm::vec4> colors);
    template<class Id>
    void addRings(const model::CrowdFrame& frame, std::span<const Id> worn,
                  std::span<const RingLabel> labels);
    void addOfBrush(const EditorState& state, const model::CrowdFrame& frame);

    std::vector<render::Marker> m_markers;
    std::vector<TagLabel> m_legend;
};

} // namespace crowd::widgets
