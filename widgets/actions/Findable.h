// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <QtCore/QString>
#include <QtGui/QIcon>

namespace crowd::widgets {

/// What can be had by typing its name: an action, a brush, a panel, a setting. Texts as the artist
/// reads them, without mnemonics.
struct Findable
{
    QString name;
    QString place;                 ///< where it is otherwise: "View › Look"
    QString keys = {};             ///< that do the same
    QString tip = {};              ///< one sentence
    QString words = {};            ///< by which else it is looked for, with blanks between
    QIcon icon = {};               ///< none: of the list
    std::optional<bool> isOn = {}; ///< none: it cannot be switched
    bool isApplicable = true;      ///< else it would do nothing now
    std::function<void()> run = {};
};

/// Indices of those that every word of `typed` fits, best first and else in their order; all, where
/// nothing is typed. A word fits, from best to worst, where it is a name, where a name begins with
/// it, where a word of a name does, inside a name, where a word of a place begins with it, one of
/// its other words, in a tip, and last where its letters come in this order in a word of a name
/// ("color" finds "Colour"). Case and accents do not count.
[[nodiscard]] std::vector<std::size_t> foundBy(const QString& typed,
                                               const std::vector<Findable>& all);

} // namespace crowd::widgets
