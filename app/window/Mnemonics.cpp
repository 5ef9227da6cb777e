// SPDX-License-Identifier: MIT
#include "app/window/Mnemonics.h"

#include <QtCore/QSet>
#include <QtGui/QAction>
#include <QtGui/QKeySequence>
#include <QtWidgets/QMenu>

#include "widgets/actions/MenuText.h"

namespace crowd::app {

namespace {

/// Upper case; null where it has none.
QChar mnemonicOf(const QString& text)
{
    const QKeySequence keys = QKeySequence::mnemonic(text);
    return keys.isEmpty() ? QChar() : keys.toString().back();
}

/// As a menu shows it again.
QString escaped(QString bare)
{
    return bare.replace(u'&', QStringLiteral("&&"));
}

/// With the first of its letters that is not taken; beginnings of words first.
QString withFreeMnemonic(const QString& text, const QSet<QChar>& taken)
{
    const QString bare = widgets::menuText(text);
    for (const bool isBeginning : {true, false}) {
        for (qsizetype i = 0; i < bare.size(); ++i) {
            const bool begins = i == 0 || bare[i - 1].isSpace();
            if (begins == isBeginning && bare[i].isLetter() && !taken.contains(bare[i].toUpper())) {
                return escaped(bare.left(i)) + u'&' + escaped(bare.mid(i));
            }
        }
    }
    return escaped(bare);
}

} // namespace

void setMnemonicsApart(const QList<QAction*>& entries)
{
    QSet<QChar> taken;
    for (QAction* entry : entries) {
        if (entry->menu() != nullptr) {
            setMnemonicsApart(entry->menu()->actions());
        }
        QChar key = mnemonicOf(entry->text());
        if (!key.isNull() && taken.contains(key)) {
            entry->setText(withFreeMnemonic(entry->text(), taken));
            key = mnemonicOf(entry->text());
        }
        if (!key.isNull()) {
            taken.insert(key);
        }
    }
}

} // namespace crowd::app
