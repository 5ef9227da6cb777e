// SPDX-License-Identifier: MIT
#include "app/window/DockLayout.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QtCore/QEvent>
#include <QtCore/QSettings>
#include <QtGui/QCursor>
#include <QtGui/QScreen>
#include <QtWidgets/QToolBar>
#include <QtWidgets/QToolButton>

namespace crowd::app {

namespace {

const QString kGeometryKey = QStringLiteral("window/geometry");
const QString kLayoutKey = QStringLiteral("window/layout");
/// Grows when docks change so much that an old layout makes no sense.
constexpr int kLayoutVersion = 2;
/// A screen smaller than this is filled, logical pixels.
constexpr QSize kRoomyScreen(1600, 1000);
constexpr QSize kSize(1280, 800);
constexpr int kSmallIcons = 18; ///< of a tool bar that would else be cut, logical pixels
/// A wide window has wide panels: a sixth of it.
constexpr int kSideShare = 6;
const char* const kWholeIcons = "wholeIcons";

/// Its last field stays in a narrow window.
void fitToolBar(QToolBar& bar, int room)
{
    if (!bar.property(kWholeIcons).isValid()) {
        bar.setProperty(kWholeIcons, bar.iconSize().width());
    }
    const int whole = bar.property(kWholeIcons).toInt();
    const auto buttons = static_cast<int>(bar.findChildren<QToolButton*>().size());
    const int needed = bar.sizeHint().width() + (whole - bar.iconSize().width()) * buttons;
    const int size = needed <= room ? whole : kSmallIcons;
    bar.setIconSize({size, size});
}

} // namespace

DockLayout::DockLayout(QMainWindow& window) : QObject(&window), m_window(window)
{
    m_arrange.setSingleShot(true);
    m_arrange.setInterval(0);
    connect(&m_arrange, &QTimer::timeout, this, [this] {
        if (m_isUntouched && !isHidden()) {
            arrange();
        }
        if (!std::exchange(m_isTwice, true)) {
            m_arrange.start();
        }
    });
    window.installEventFilter(this);
}

bool DockLayout::eventFilter(QObject* window, QEvent* event)
{
    if (event->type() == QEvent::Resize) {
        arrangeSoon();
        fitToolBars();
    } else if (event->type() == QEvent::MouseButtonPress) {
        m_isUntouched = false; // a border between panels
    }
    return QObject::eventFilter(window, event);
}

void DockLayout::addAll(const DockParts& parts)
{
    m_isSeen.assign(dockTable().size(), 0);
    for (const DockInfo& info : dockTable()) {
        QDockWidget* dock = info.make(parts);
        m_window.addDockWidget(info.area, dock);
        m_docks.push_back(dock);
        connect(dock, &QDockWidget::topLevelChanged, this, [this, dock](bool isFloating) {
            m_isUntouched = false;
            if (!isFloating) { // in front of where it has come to, once it is there
                QMetaObject::invokeMethod(dock, &QDockWidget::raise, Qt::QueuedConnection);
            }
        });
        connect(dock, &QDockWidget::visibilityChanged, this, [this, &info](bool isSeen) {
            m_isSeen[static_cast<std::size_t>(info.id)] = isSeen ? 1 : 0;
            if ((info.tabAfter && info.height > 0) || info.area == Qt::BottomDockWidgetArea) {
                arrangeSoon(); // those at the bottom press the sides together
            }
        });
        if (!info.isShown) {
            dock->hide();
        }
    }
    for (const DockInfo& info : dockTable()) {
        if (info.tabAfter) {
            m_window.tabifyDockWidget(dock(*info.tabAfter), dock(info.id));
        }
    }
    for (const DockInfo& info : dockTable()) {
        if (info.tabAfter && !dockTable()[static_cast<std::size_t>(*info.tabAfter)].tabAfter) {
            dock(*info.tabAfter)->raise();
        }
    }
}

std::vector<QDockWidget*> DockLayout::replaceAll(const DockParts& parts)
{
    for (QDockWidget* dock : m_docks) {
        dock->disconnect(this);
        m_window.removeDockWidget(dock);
        dock->setParent(nullptr);
    }
    std::vector<QDockWidget*> before = std::exchange(m_docks, {});
    addAll(parts);
    return before;
}

QByteArray DockLayout::places() const
{
    return m_window.saveState(kLayoutVersion);
}

void DockLayout::putBack(const QByteArray& places)
{
    const bool wasUntouched = m_isUntouched;
    fitToolBars(); // of new ones
    m_window.restoreState(places, kLayoutVersion);
    m_isUntouched = wasUntouched;
}

void DockLayout::showToolSettings()
{
    QDockWidget* settings = dock(DockId::BrushSettings);
    const bool isBehind =
        !settings->isHidden() && m_isSeen[static_cast<std::size_t>(DockId::BrushSettings)] == 0;
    const auto isUnderPointer = [](const QDockWidget* other) {
        return !other->visibleRegion().isEmpty() &&
               other->rect().contains(other->mapFromGlobal(QCursor::pos()));
    };
    if (isBehind && std::ranges::none_of(m_window.tabifiedDockWidgets(settings), isUnderPointer)) {
        settings->raise();
    }
}

void DockLayout::arrangeSoon()
{
    m_isTwice = false;
    m_arrange.start();
}

void DockLayout::arrange()
{
    for (const Qt::DockWidgetArea area :
         {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea, Qt::BottomDockWidgetArea}) {
        std::map<DockId, int> rows;
        for (const DockInfo& info : dockTable()) {
            if (info.area == area && info.width > 0) {
                const int width = std::max(info.width, m_window.width() / kSideShare);
                m_window.resizeDocks({dock(info.id)}, {width}, Qt::Horizontal);
            }
            const bool isSeen = !info.tabAfter || m_isSeen[static_cast<std::size_t>(info.id)] != 0;
            if (info.area == area && info.height > 0 && isSeen) {
                rows[firstOf(info.id)] = info.height;
            }
        }
        QList<QDockWidget*> docks;
        QList<int> heights;
        for (const auto& [id, height] : rows) {
            docks << dock(id);
            heights << height;
        }
        m_window.resizeDocks(docks, heights, Qt::Vertical);
    }
}

DockId DockLayout::firstOf(DockId id)
{
    const DockInfo& info = dockTable()[static_cast<std::size_t>(id)];
    return info.tabAfter ? firstOf(*info.tabAfter) : id;
}

void DockLayout::fitToolBars()
{
    for (auto* bar : m_window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
        fitToolBar(*bar, m_window.width());
    }
}

QRect DockLayout::placeOnSmallScreen(const QRect& screen, const QSize& least)
{
    const QSize size = kSize.boundedTo(screen.size() * 9 / 10);
    QRect place(screen.topLeft(), size.expandedTo(least));
    place.translate(0, std::max(0, (screen.height() - place.height()) / 2));
    return place;
}

void DockLayout::fitToScreen()
{
    const QRect screen = m_window.screen()->availableGeometry();
    if (screen.width() < kRoomyScreen.width() || screen.height() < kRoomyScreen.height()) {
        // For when it is no longer so large.
        m_window.setGeometry(placeOnSmallScreen(screen, m_window.minimumSizeHint()));
        m_window.setWindowState(m_window.windowState() | Qt::WindowMaximized);
        return;
    }
    QRect place(QPoint(), screen.size() * 9 / 10);
    place.moveCenter(screen.center());
    m_window.setGeometry(place);
}

void DockLayout::restore()
{
    arrange();
    m_window.resize(kSize);
    m_initial = m_window.saveState(kLayoutVersion);
    const QSettings settings;
    if (!settings.contains(kGeometryKey) ||
        !m_window.restoreGeometry(settings.value(kGeometryKey).toByteArray())) {
        fitToScreen();
    }
    m_isUntouched =
        !m_window.restoreState(settings.value(kLayoutKey).toByteArray(), kLayoutVersion);
}

void DockLayout::save() const
{
    QSettings settings;
    settings.setValue(kGeometryKey, m_window.saveGeometry());
    settings.setValue(kLayoutKey, isHidden() ? m_beforeHiding : m_window.saveState(kLayoutVersion));
}

void DockLayout::reset()
{
    const bool wasHidden = isHidden();
    m_beforeHiding.clear();
    m_window.restoreState(m_initial, kLayoutVersion);
    m_isUntouched = true;
    arrange();
    arrangeSoon();
    if (wasHidden) {
        Q_EMIT hiddenChanged(false);
    }
}

void DockLayout::setHidden(bool isHidden)
{
    if (isHidden == this->isHidden()) {
        return;
    }
    if (isHidden) {
        m_beforeHiding = m_window.saveState(kLayoutVersion);
        for (QDockWidget* dock : m_docks) {
            dock->hide();
        }
        for (auto* bar : m_window.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) {
            bar->hide();
        }
    } else {
        m_window.restoreState(std::exchange(m_beforeHiding, {}), kLayoutVersion);
    }
    Q_EMIT hiddenChanged(isHidden);
}

} // namespace crowd::app
