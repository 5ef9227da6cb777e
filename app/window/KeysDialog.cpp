// SPDX-License-Identifier: MIT
#include "app/window/KeysDialog.h"

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QTabWidget>
#include <QtWidgets/QTextBrowser>
#include <QtWidgets/QVBoxLayout>

namespace crowd::app {

namespace {

/// A table of two columns under headings, as rich text.
class KeyTable
{
public:
    void heading(const QString& text)
    {
        m_html += QStringLiteral("<tr><td colspan='2' style='padding:12px 0 3px 0'><b>%1</b></td>"
                                 "</tr>")
                      .arg(text.toHtmlEscaped());
    }
    void row(const QString& keys, const QString& what)
    {
        m_html += QStringLiteral("<tr><td style='padding:2px 18px 2px 10px; white-space:nowrap'>"
                                 "%1</td><td style='padding:2px 0'>%2</td></tr>")
                      .arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
    }
    [[nodiscard]] QTextBrowser* browser(QWidget* parent) const
    {
        auto* page = new QTextBrowser(parent);
        page->setFrameShape(QFrame::NoFrame);
        page->setHtml(QStringLiteral("<table>%1</table>").arg(m_html));
        return page;
    }

private:
    QString m_html;
};

} // namespace

KeysDialog::KeysDialog(const widgets::ActionRegistry& actions, widgets::ButtonMapping buttons,
                       QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Mouse and Keys"));
    auto* pages = new QTabWidget(this);
    pages->addTab(picturePage(actions, buttons), tr("In the Picture"));
    pages->addTab(shortcutPage(actions), tr("Shortcuts"));
    auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages);
    layout->addWidget(close);
    resize(640, 620);
}

QWidget* KeysDialog::picturePage(const widgets::ActionRegistry& actions,
                                 widgets::ButtonMapping buttons)
{
    const auto keysOf = [&](const char* id) {
        return actions.action(id)->shortcut().toString(QKeySequence::NativeText);
    };
    KeyTable table;
    table.heading(tr("Painting with a brush"));
    if (buttons == widgets::ButtonMapping::Paper) {
        table.row(tr("Left button"), tr("paints one character or place"));
        table.row(tr("Middle button"), tr("paints in a circle"));
        table.row(tr("Right button"), tr("paints in a rectangle"));
    } else {
        table.row(tr("Left button"), tr("paints; Escape takes the stroke back"));
        table.row(tr("Right button"), tr("opens the brushes at the cursor"));
    }
    table.row(tr("%1 and %2, Ctrl + wheel").arg(keysOf("brush-smaller"), keysOf("brush-larger")),
              tr("smaller and larger brush; dragging with Shift does it too"));
    table.row(tr("+ and −"), tr("the brush’s main number: how many, how strong"));
    table.heading(tr("Paths and behaviour"));
    table.row(tr("Click with the path brush"), tr("adds a place; on the first place: closes it"));
    table.row(keysOf("path-end"), tr("ends the path; the next click begins another one"));
    table.row(tr("Drag a place, or its circle"), tr("moves it, or changes its size (selection)"));
    table.row(tr("%1, %2").arg(keysOf("step"), keysOf("stop")),
              tr("one step; back to the start, everybody where the scene has them"));
    table.row(keysOf("keep-pose"), tr("keeps everybody where they are now"));
    table.heading(tr("Selecting"));
    table.row(tr("Click, or drag a rectangle"), tr("selects; Shift adds, Ctrl changes"));
    table.row(tr("Drag somebody"), tr("moves those who are selected, to free seats or the ground"));
    table.row(tr("Escape"), tr("selects nobody"));
    table.heading(tr("Looking around"));
    table.row(tr("Middle button"), tr("orbits; with Shift it pans, with Ctrl it comes nearer"));
    table.row(tr("Space or Alt held"), tr("left orbits, middle pans, right comes nearer"));
    table.row(tr("Wheel"), tr("goes to the point under the cursor"));
    table.row(tr("%1, %2").arg(keysOf("frame-selection"), keysOf("frame-all")),
              tr("show those who are selected; show everything"));
    table.row(tr("1 to 9, Ctrl + 1 to 9"), tr("go to a camera; keep this view as that camera"));
    table.row(tr("%1, %2, %3").arg(keysOf("view-front"), keysOf("view-side"), keysOf("view-top")),
              tr("from the front, the side, above; also with Alt and the digit"));
    table.row(keysOf("projection"), tr("perspective or orthographic"));
    table.row(tr("Shift + F"),
              tr("flies: W A S D, Q and E, the wheel for the speed, a click lands"));
    table.heading(tr("Playing and the window"));
    table.row(tr("Space tapped"), tr("plays and pauses"));
    table.row(keysOf("hide-panels"), tr("hides the panels, and brings them back"));
    table.row(keysOf("full-screen"), tr("fills the screen"));
    return table.browser(this);
}

QWidget* KeysDialog::shortcutPage(const widgets::ActionRegistry& actions)
{
    KeyTable table;
    table.heading(tr("The preferences change them"));
    for (const widgets::ActionSpec& spec : actions.specs()) {
        QStringList keys;
        for (const QKeySequence& shortcut : actions.action(spec.id)->shortcuts()) {
            keys << shortcut.toString(QKeySequence::NativeText);
        }
        if (!keys.isEmpty()) {
            table.row(keys.join(QStringLiteral(", ")), actions.action(spec.id)->statusTip());
        }
    }
    return table.browser(this);
}

} // namespace crowd::app
