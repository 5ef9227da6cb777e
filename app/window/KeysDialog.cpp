// SPDX-License-Identifier: MIT
#include "app/window/KeysDialog.h"

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QTextBrowser>
#include <QtWidgets/QVBoxLayout>

namespace crowd::app {

namespace {

QString row(const QString& keys, const QString& what)
{
    return QStringLiteral("<tr><td style='padding:2px 16px 2px 0'><b>%1</b></td><td>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
}

} // namespace

KeysDialog::KeysDialog(const widgets::ActionRegistry& actions, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Keys and Mouse"));
    QString text = QStringLiteral("<h3>%1</h3><table>").arg(tr("In the picture"));
    text += row(tr("Left button"), tr("paints with the active brush, or selects"));
    text += row(tr("Right button"), tr("opens the brushes at the cursor"));
    text += row(tr("Middle button, Alt + left"), tr("turn the view; with Shift shift it"));
    text += row(tr("Wheel"), tr("goes to the point under the cursor"));
    text += row(tr("Ctrl + wheel, [ and ]"), tr("size of the brush"));
    text += row(tr("+ and −"), tr("main number of the brush"));
    text += row(tr("Space held"), tr("navigates with the left button; tapped it plays and pauses"));
    text += row(tr("Shift + F"), tr("flies with W A S D and the mouse; Escape ends it"));
    text += row(tr("Escape"), tr("takes the stroke in progress back, or selects nobody"));
    text += QStringLiteral("</table><h3>%1</h3><table>").arg(tr("Everywhere"));
    for (const widgets::ActionSpec& spec : actions.specs()) {
        const QAction* action = actions.action(spec.id);
        if (!action->shortcut().isEmpty()) {
            text += row(action->shortcut().toString(QKeySequence::NativeText), action->statusTip());
        }
    }
    text += QStringLiteral("</table>");
    auto* page = new QTextBrowser(this);
    page->setHtml(text);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(page);
    layout->addWidget(buttons);
    resize(620, 640);
}

} // namespace crowd::app
