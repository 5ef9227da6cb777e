// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>

#include <QtCore/QObject>
#include <QtCore/QStringList>

#include "widgets/actions/ActionRegistry.h"

class QMenu;

namespace crowd::app {

/// Two actions of the registry for one number.
struct NumberedKey
{
    const char* go;
    const char* goText;
    const char* goKeys;
    const char* keep;
    const char* keepText;
    const char* keepKeys;
};

inline constexpr std::size_t kNumberedKeys = 9;
using NumberedKeys = std::array<NumberedKey, kNumberedKeys>;

/// What is kept under numbers, and what their keys do.
struct NumberedThings
{
    const char* goIcon;
    const char* goTip;
    const char* keepIcon;
    const char* keepTip;
    std::function<QStringList()> names; ///< of those there are, in their order
    std::function<void(std::size_t)> go;
    std::function<void(std::size_t)> keep;
    std::function<QString()> none;  ///< says that there are none
    std::function<QString()> fresh; ///< the name of one more
};

/// Nine things of a scene under keys: one goes to each, one keeps the present as it. Main thread
/// only; registry and keys outlive it.
class NumberedActions : public QObject
{
    Q_OBJECT

public:
    NumberedActions(widgets::ActionRegistry& actions, const NumberedKeys& keys,
                    NumberedThings things, QObject* parent);

    /// Fills two menus whenever they are shown: all by name, and those that can be kept.
    void attach(QMenu* goTo, QMenu* keep);
    /// As the artist has it.
    [[nodiscard]] QString keepShortcut(std::size_t index) const;
    [[nodiscard]] QString goToShortcut(std::size_t index) const;

private:
    void fillGoTo(QMenu* menu);
    void fillKeep(QMenu* menu);

    widgets::ActionRegistry& m_actions;
    const NumberedKeys& m_keys;
    NumberedThings m_things;
};

} // namespace crowd::app
