// SPDX-License-Identifier: MIT
#include "app/window/KeysDialog.h"

#include <QtGui/QPainter>
#include <QtGui/QResizeEvent>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QTabWidget>
#include <QtWidgets/QTextBrowser>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"

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

/// The page as it is printed, as wide as there is room.
class CardView : public QWidget
{
public:
    CardView(const std::vector<CardSection>& sections, QWidget* parent)
        : QWidget(parent), m_card(sections, kPage)
    {
        setObjectName(QStringLiteral("cardView"));
    }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override
    {
        return static_cast<int>(width * kPage.height() / kPage.width());
    }
    [[nodiscard]] QSize sizeHint() const override
    {
        return {kCardWidth, heightForWidth(kCardWidth)};
    }

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        setMinimumHeight(heightForWidth(event->size().width()));
    }
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QPainter painter(this);
        painter.fillRect(rect(), Qt::white);
        painter.scale(width() / kPage.width(), width() / kPage.width());
        m_card.paint(painter);
    }

private:
    static constexpr QSizeF kPage{2480.0, 3508.0}; ///< A4, 300 dots an inch
    static constexpr int kCardWidth = 820;         ///< logical pixels

    QuickCard m_card;
};

} // namespace

KeysDialog::KeysDialog(const widgets::ActionRegistry& actions, widgets::ButtonMapping buttons,
                       QWidget* parent)
    : QDialog(parent), m_sections(cardSections(actions, buttons))
{
    setWindowTitle(tr("Quick Reference Card"));
    auto* pages = new QTabWidget(this);
    pages->addTab(cardPage(), tr("At a Glance"));
    pages->addTab(shortcutPage(actions), tr("Shortcuts"));
    auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
    QPushButton* save = close->addButton(tr("Save to &Print…"), QDialogButtonBox::ActionRole);
    save->setObjectName(QStringLiteral("saveCard"));
    connect(save, &QPushButton::clicked, this, &KeysDialog::saveCard);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages);
    layout->addWidget(close);
    const QSize room = parentWidget() != nullptr ? parentWidget()->screen()->availableSize()
                                                 : screen()->availableSize();
    resize(QSize(880, 760).boundedTo(room - QSize(40, 60))); // with the frame of the window
}

void KeysDialog::addMouse(CardList& list, widgets::ButtonMapping buttons)
{
    addPainting(list, buttons);
    addLooking(list);
}

void KeysDialog::addPainting(CardList& list, widgets::ButtonMapping buttons)
{
    list.heading(tr("Painting with a brush"));
    if (buttons == widgets::ButtonMapping::Paper) {
        list.row(tr("Left button"), tr("paints one character or place"));
        list.row(tr("Middle button"), tr("paints in a circle"));
        list.row(tr("Right button"), tr("paints in a rectangle"));
    } else {
        list.row(tr("Left button"), tr("paints; Escape takes the stroke back"));
        list.row(tr("Right button"), tr("opens the brushes at the cursor"));
    }
    list.row(tr("%1 and %2, Ctrl + wheel")
                 .arg(list.keysOf("brush-smaller"), list.keysOf("brush-larger")),
             tr("smaller and larger brush; dragging with Shift does it too"));
    list.row(tr("+ and −"), tr("the brush’s main number: how many, how strong"));
    list.heading(tr("Paths and behaviour"));
    list.row(tr("Click with the path brush"), tr("adds a place; on the first place: closes it"));
    list.row(list.keysOf("path-end"), tr("ends the path; the next click begins another one"));
    list.row(tr("Drag a place, or its circle"), tr("moves it, or changes its size (selection)"));
    list.row(tr("%1, %2, %3")
                 .arg(list.keysOf("step"), list.keysOf("step-back"), list.keysOf("catch-up")),
             tr("one step on, one back; to the latest moment of the run"));
    list.row(list.keysOf("take-from-here"),
             tr("goes on from the moment shown and forgets what came after it"));
    list.row(list.keysOf("stop"), tr("back to the start, everybody where the scene has them"));
    list.row(list.keysOf("keep-pose"), tr("keeps everybody where they are now"));
}

void KeysDialog::addLooking(CardList& list)
{
    list.heading(tr("Selecting"));
    list.row(tr("Click, or drag a rectangle"), tr("selects; Shift adds, Ctrl changes"));
    list.row(tr("Drag somebody"), tr("moves those who are selected, to free seats or the ground"));
    list.row(tr("Escape"), tr("selects nobody"));
    list.heading(tr("Looking around"));
    list.row(tr("Middle button"), tr("orbits; with Shift it pans, with Ctrl it comes nearer"));
    list.row(tr("Space or Alt held"), tr("left orbits, middle pans, right comes nearer"));
    list.row(tr("Wheel"), tr("goes to the point under the cursor"));
    list.row(tr("%1, %2").arg(list.keysOf("frame-selection"), list.keysOf("frame-all")),
             tr("show those who are selected; show everything"));
    list.row(tr("1 to 9, Ctrl + 1 to 9"), tr("go to a camera; keep this view as that camera"));
    list.row(tr("%1, %2, %3")
                 .arg(list.keysOf("view-front"), list.keysOf("view-side"), list.keysOf("view-top")),
             tr("from the front, the side, above; also with Alt and the digit"));
    list.row(list.keysOf("projection"), tr("perspective or orthographic"));
    list.row(tr("Shift + F"),
             tr("flies: W A S D, Q and E, the wheel for the speed, a click lands"));
    list.heading(tr("States"));
    list.row(tr("%1 to 9").arg(list.keysOf("state-1")), tr("recall a state of the crowd"));
    list.row(tr("%1 to 9").arg(list.keysOf("state-keep-1")),
             tr("keep it, or who is selected, as that state"));
    list.heading(tr("Playing and the window"));
    list.row(tr("Space tapped"), tr("plays and pauses"));
    list.row(list.keysOf("find"), tr("finds actions, brushes, panels and settings by name"));
    list.row(list.keysOf("hide-panels"), tr("hides the panels, and brings them back"));
    list.row(list.keysOf("full-screen"), tr("fills the screen"));
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

QWidget* KeysDialog::cardPage()
{
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setVerticalScrollBarPolicy(
        Qt::ScrollBarAlwaysOn); // else width and height chase each other
    area->setWidget(new CardView(m_sections, area));
    return area;
}

void KeysDialog::saveCard()
{
    QString path = QFileDialog::getSaveFileName(
        this, tr("Save the Card"), QStringLiteral("crowdbrush.pdf"), tr("Pages to print (*.pdf)"));
    if (path.isEmpty()) {
        return;
    }
    path += path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive) ? QString()
                                                                       : QStringLiteral(".pdf");
    if (const auto saved = writeCard(m_sections, path); !saved) {
        QMessageBox::warning(this, tr("Save the Card"), model::translated(saved.error().said));
    }
}

} // namespace crowd::app
