// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "model/document/SceneDocument.h"
#include "model/scene/Timeline.h"

namespace crowd::widgets {

/// Makes what is performed while a scene plays marks of its timeline, while it is on: what happens
/// in one go is one undo step, and what a stroke of the event brush sends is one mark, in which
/// each hears it as much later as he did. Main thread; the document outlives it.
class MarkRecorder : public QObject
{
    Q_OBJECT

public:
    MarkRecorder(model::SceneDocument& document, QObject* parent);

    void setOn(bool isOn);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    /// For what is performed next; 0: it is not to become a mark, or there is no room.
    [[nodiscard]] model::MarkId nextId();
    /// They have been performed, each at its time; ids by nextId().
    void add(model::Timeline performed);
    /// What was performed is becoming marks right now: it has happened already.
    [[nodiscard]] bool isKeeping() const { return m_isKeeping; }
    /// Another scene is there: what has not become a mark yet belongs to the one before.
    void forget();

Q_SIGNALS:
    void changed(bool isOn);

private:
    void keep();
    [[nodiscard]] static QString stepText(const model::Scene& scene,
                                          const model::Timeline& performed);

    model::SceneDocument& m_document;
    QTimer m_keep;
    model::Timeline m_performed; ///< that are not in the scene yet
    model::MarkId m_last = 0;    ///< that was given
    bool m_isOn = false;
    bool m_isKeeping = false;
};

} // namespace crowd::widgets
