// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QTimer>

class QMenu;

namespace crowd::app {

/// Fills a menu with the languages there are, each in its own name, and the system's. `choose` gets
/// the code of the one that is chosen, and lives as long as the menu.
void fillLanguageMenu(QMenu& menu, const std::function<void(const QString&)>& choose);

/// Another language waits until nothing is in the way: panels and menus are made anew, and nobody
/// is to lose what is in their hands. Main thread only.
class LanguageSwitch : public QObject
{
    Q_OBJECT

public:
    LanguageSwitch(std::function<bool()> isFree, QObject* parent);

    /// Remembers it for the next starts too.
    void choose(const QString& code);

Q_SIGNALS:
    /// Something is in the way: it comes later by itself.
    void delayed();

private:
    /// False: not yet.
    bool take();

    std::function<bool()> m_isFree;
    QString m_wanted;
    QTimer m_look; ///< whether the way is free
};

} // namespace crowd::app
