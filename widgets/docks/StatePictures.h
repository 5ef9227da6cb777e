// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>
#include <memory>

#include <QtCore/QObject>
#include <QtCore/QSize>
#include <QtCore/QTimer>
#include <QtGui/QIcon>

#include "model/scene/State.h"

namespace crowd::widgets {

class EditorState;

/// Small pictures of the scene in its states, as the view shows it when they are drawn: one after
/// the other while nothing else happens. A picture stays until its state is kept anew. Main thread.
class StatePictures : public QObject
{
    Q_OBJECT

public:
    static constexpr QSize kSize{56, 36}; ///< logical pixels

    explicit StatePictures(EditorState& state, QObject* parent);

    /// A plain symbol until it is drawn.
    [[nodiscard]] QIcon of(const model::State& kept);
    void forget(); ///< it is another scene

Q_SIGNALS:
    void drawn();

private:
    struct Picture
    {
        std::shared_ptr<const model::StoredRows> people; ///< that it is of
        QIcon icon;                                      ///< null: not yet
        int tries = 0;
    };
    void drawNext();
    [[nodiscard]] QIcon draw(const model::State& kept, bool& isComplete) const;

    EditorState& m_state;
    std::map<model::StateId, Picture> m_pictures;
    QTimer m_next;
};

} // namespace crowd::widgets
