// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QObject>

#include "model/document/SceneDocument.h"

namespace crowd::widgets {

/// Which path is being painted or looked at, which place is being drawn, and which are selected, in
/// the order in which they were chosen. Follows the document: what vanishes is dropped, and chosen
/// again if the step that took it away is undone. Not an edit; cannot be undone. Main thread; the
/// document outlives it.
class PathFocus : public QObject
{
    Q_OBJECT

public:
    explicit PathFocus(model::SceneDocument& document, QObject* parent = nullptr);

    /// 0: none.
    [[nodiscard]] model::PathId path() const { return m_path; }
    /// Whether the next place goes to the end of that path.
    [[nodiscard]] bool isPainting() const { return m_isPainting; }
    void paint(model::PathId path); ///< extend it from now on
    void look(model::PathId path);  ///< highlight it
    /// The place that the next corner goes to; 0: that begins another one.
    [[nodiscard]] model::PlaceId shaped() const { return m_shaped; }
    void shape(model::PlaceId place);
    /// The next place begins another path, the next corner another place.
    void end();

    [[nodiscard]] const std::vector<model::PlaceId>& places() const { return m_places; }
    [[nodiscard]] bool isSelected(model::PlaceId place) const;
    void select(std::vector<model::PlaceId> places);
    void toggle(model::PlaceId place);

Q_SIGNALS:
    void changed();

private:
    void follow(const model::SceneChange& change);
    void takeBack();

    model::SceneDocument& m_document;
    model::PathId m_path = 0;
    bool m_isPainting = false;
    /// What was chosen when it vanished, until something else is chosen.
    model::PathId m_gonePath = 0;
    std::vector<model::PlaceId> m_gone;
    model::PlaceId m_shaped = 0;
    std::vector<model::PlaceId> m_places;
};

} // namespace crowd::widgets
