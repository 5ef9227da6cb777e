// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <QtCore/QTimer>
#include <QtGui/QColor>
#include <QtGui/QIcon>
#include <QtWidgets/QTreeWidget>

#include "behavior/session/SessionTally.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

inline constexpr QColor kTroubleColor{208, 80, 64};
/// A dot of the colour that a place or a path has in the picture.
[[nodiscard]] QIcon colorIcon(const std::array<std::uint8_t, 3>& color);

/// Paths with their places, and places alone, as a tree: what is selected in it is selected in the
/// picture and the other way round, and renaming is one undo step. While a session runs, its people
/// are counted. Follows the scene, the session and the focus by itself; the state outlives it. Main
/// thread only.
class EnvironmentTree : public QTreeWidget
{
    Q_OBJECT

public:
    EnvironmentTree(EditorState& state, QWidget* parent);

    void rebuild();
    /// Colours what a session has something to say about.
    void showProblems();
    /// Of the first that is selected and has one; empty: none.
    [[nodiscard]] QString problemOfChosen() const;
    /// Once for each choice, and for each place that a chosen path grows by: who scrolls on is left
    /// alone.
    void scrollToSelection();

Q_SIGNALS:
    /// It has other items.
    void rebuilt();
    /// It shows what is selected, which may be something else.
    void chosen();

private:
    /// Of items, and where the place of a path is in it.
    enum ItemType { KindItem = 1001, PathItem, PlaceItem };
    static constexpr int kIndexRole = Qt::UserRole + 1;

    /// What it last scrolled to: the path, the places, and how many places it has.
    struct Shown
    {
        model::PathId path = 0;
        std::vector<model::PlaceId> places;
        int length = 0;
        friend bool operator==(const Shown&, const Shown&) = default;
    };

    void followScene();
    void followSession();
    void keepRowsInSight();
    void addPaths();
    void addPlaces();
    static QTreeWidgetItem* addPlace(QTreeWidgetItem& parent, const model::Place& place);
    [[nodiscard]] behavior::SessionTally tally() const;
    void showCounts();
    [[nodiscard]] static QString sizeText(const model::Place& place);
    void showSelection();
    void takeSelection();
    [[nodiscard]] QString problemOf(const QTreeWidgetItem& item) const;
    void rename(QTreeWidgetItem* item);
    void showMenu(const QPoint& position);

    EditorState& m_state;
    QTimer m_rebuild;
    QTimer m_count;                 ///< until people of the session are counted again
    double m_countedSeconds = -1.0; ///< of the session, when they last were
    behavior::SessionTally m_tally; ///< as it is shown
    Shown m_shown;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
