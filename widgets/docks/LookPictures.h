// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include <QtCore/QObject>
#include <QtCore/QSize>
#include <QtCore/QTimer>
#include <QtGui/QIcon>

#include "model/scene/LookPreset.h"

class QWidget;

namespace crowd::widgets {

class EditorState;

/// Small pictures of the view in the looks of its scene, as it is when they are drawn: one after
/// the other while nothing else happens. A picture stays until its look is changed, or all are let
/// go. Main thread.
class LookPictures : public QObject
{
    Q_OBJECT

public:
    static constexpr QSize kSize{64, 40}; ///< logical pixels

    /// They are drawn while the panel is seen, which is the parent.
    LookPictures(EditorState& state, QWidget& panel);

    /// A plain symbol until it is drawn.
    [[nodiscard]] QIcon of(const model::LookPreset& look);
    void forget(); ///< camera, light or scene are others

Q_SIGNALS:
    void drawn();

private:
    struct Picture
    {
        model::LookPreset look; ///< that it is of
        QIcon icon;             ///< null: not yet
        int tries = 0;
    };
    void drawNext();
    [[nodiscard]] QIcon draw(const model::LookPreset& look, bool& isComplete) const;

    EditorState& m_state;
    QWidget& m_panel;
    std::map<model::LookId, Picture> m_pictures;
    QTimer m_next;
};

} // namespace crowd::widgets
