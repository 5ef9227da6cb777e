// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include <QtCore/QObject>

#include "model/document/SceneDocument.h"

namespace crowd::widgets {

/// Short strokes that follow each other without a pause, undone and redone together where the
/// artist wants it. Their steps stay apart in the document. Main thread; the document outlives it.
class UndoGroups : public QObject
{
    Q_OBJECT

public:
    explicit UndoGroups(model::SceneDocument& document) : m_document(document) {}

    /// Off: each step by itself.
    void setOn(bool isOn);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    /// The last step is a stroke of this brush, begun and ended at these moments, seconds.
    void note(int brush, double begin, double end);
    /// The step before or after what is shown, with those of its group. How many were done.
    int undo();
    int redo();
    /// Those of the undo stack's steps that have the same number go together; 0: by itself.
    [[nodiscard]] std::uint64_t groupAt(int index) const;

Q_SIGNALS:
    void changed();

private:
    struct Stroke
    {
        std::uint64_t step = 0; ///< SceneCommand::serial
        int brush = 0;
        double end = 0.0;
        std::uint64_t group = 0;
    };

    model::SceneDocument& m_document;
    bool m_isOn = false;
    Stroke m_last;                                   ///< that was short
    std::map<std::uint64_t, std::uint64_t> m_groups; ///< by step
};

} // namespace crowd::widgets
