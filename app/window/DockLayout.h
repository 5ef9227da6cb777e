// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QByteArray>
#include <QtCore/QObject>
#include <QtCore/QRect>
#include <QtCore/QSize>
#include <QtCore/QTimer>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMainWindow>

#include "app/window/DockTable.h"

namespace crowd::app {

/// Where the panels of the window are: remembered between runs, put back on demand, and out of the
/// way while the artist wants nothing but the picture. The window owns the panels and outlives
/// this. Main thread only.
class DockLayout : public QObject
{
    Q_OBJECT

public:
    explicit DockLayout(QMainWindow& window);

    /// Makes all panels of the table and puts them where they are in a new installation.
    void addAll(const DockParts& parts);
    [[nodiscard]] QDockWidget* dock(DockId id) const
    {
        return m_docks[static_cast<std::size_t>(id)];
    }
    template<class Dock>
    [[nodiscard]] Dock* dock(DockId id) const
    {
        return static_cast<Dock*>(dock(id));
    }
    /// In the order of DockId.
    [[nodiscard]] const std::vector<QDockWidget*>& docks() const { return m_docks; }
    /// The window is gone: so are its panels.
    void forget() { m_docks.clear(); }
    /// Makes all panels anew, in the language of now; those that were there are handed over, out
    /// of the window.
    [[nodiscard]] std::vector<QDockWidget*> replaceAll(const DockParts& parts);
    /// Where panels and tool bars are in the window.
    [[nodiscard]] QByteArray places() const;
    void putBack(const QByteArray& places);

    /// The layout of a new installation is the present one; then what was remembered of window and
    /// panels takes its place. The first time the window fits its screen.
    void restore();
    void save() const;
    /// All panels back to where they are in a new installation.
    void reset();

    /// The settings of the tool come in front of the panels that they are behind, unless the
    /// pointer is in one of those: then the artist chose the tool there, or by its key for what is
    /// there.
    void showToolSettings();

    /// Hides panels and tool bars, or shows those that were there before.
    void setHidden(bool isHidden);
    [[nodiscard]] bool isHidden() const { return !m_beforeHiding.isEmpty(); }
    /// Where the window is on a small screen when it does not fill it, without its frame: the title
    /// above it can be grasped.
    [[nodiscard]] static QRect placeOnSmallScreen(const QRect& screen, const QSize& least);

Q_SIGNALS:
    void hiddenChanged(bool isHidden);

protected:
    bool eventFilter(QObject* window, QEvent* event) override;

private:
    void fitToolBars();
    void fitToScreen();
    /// The sizes of a new installation: at the start, and when the window has another size, until
    /// the artist moves a border.
    void arrange();
    void arrangeSoon(); ///< once the window has its size, and once panels have their widths

    /// The first of the panels that it is behind.
    [[nodiscard]] static DockId firstOf(DockId id);

    QMainWindow& m_window;
    std::vector<QDockWidget*> m_docks;
    std::vector<char> m_isSeen; ///< by DockId: in front, where several are behind each other
    QByteArray m_initial;
    QByteArray m_beforeHiding; ///< empty while the panels are there
    bool m_isUntouched = false;
    QTimer m_arrange;       ///< the window has got another size
    bool m_isTwice = false; ///< panels have had their new widths, on which their heights depend
};

} // namespace crowd::app
