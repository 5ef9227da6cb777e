// SPDX-License-Identifier: MIT
#include "app/window/WelcomeHint.h"

#include <algorithm>

#include <QtCore/QEvent>
#include <QtCore/QSettings>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>

namespace crowd::app {

namespace {

const QString kSeenKey = QStringLiteral("window/hasSeenWelcome");
constexpr int kBorder = 14;
constexpr int kRoomOfWork = 46; ///< below it, for the bar of long work
constexpr int kEditsToKnow = 3; ///< after so many somebody has found out

/// Dark on any picture and in any theme, like the other plates over it.
const QString kStyle = QStringLiteral(R"(
#welcomeHint { background: rgba(20, 22, 26, 205); border: none; border-radius: 8px; }
#welcomeHint QLabel { color: rgb(235, 236, 240); background: transparent; }
#welcomeHint QToolButton { color: rgb(235, 236, 240); border: none; border-radius: 4px;
                           padding: 1px 6px; background: transparent; }
#welcomeHint QToolButton:hover { background: rgb(70, 72, 78); }
)");

} // namespace

void WelcomeHint::showOnce(QWidget* picture, const widgets::EditorState& state)
{
    if (!QSettings().value(kSeenKey).toBool()) {
        new WelcomeHint(picture, state); // the picture's child
    }
}

WelcomeHint::WelcomeHint(QWidget* picture, const widgets::EditorState& state) : QFrame(picture)
{
    setObjectName(QStringLiteral("welcomeHint"));
    setStyleSheet(kStyle);
    auto* text = new QLabel(
        tr("<b>Drag</b> over free seats or open ground: characters come. &nbsp;<b>Right click</b>: "
           "the brushes.<br><b>Space</b> and drag: look around. &nbsp;<b>Ctrl+Z</b>: take it back. "
           "&nbsp;<b>F1</b>: all keys."),
        this);
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setToolTip(tr("Close, and do not show this again"));
    close->setFocusPolicy(Qt::NoFocus);
    connect(close, &QToolButton::clicked, this, &WelcomeHint::dismiss);
    connect(&state.document().undoStack(), &QUndoStack::indexChanged, this, [this](int index) {
        if (index >= kEditsToKnow) {
            dismiss();
        }
    });
    const auto showForItsBrush = [this, &state] {
        setVisible(state.tool() == widgets::ToolId::BrushCreate);
    };
    connect(&state, &widgets::EditorState::toolChanged, this, showForItsBrush);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(13, 9, 7, 9);
    layout->addWidget(text, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    picture->installEventFilter(this);
    place();
    showForItsBrush();
}

void WelcomeHint::dismiss()
{
    QSettings().setValue(kSeenKey, true);
    hide();
    deleteLater();
}

/// In one piece where there is room, else in as many lines as it takes.
void WelcomeHint::place()
{
    const int room = std::max(1, parentWidget()->width() - 2 * kBorder);
    auto* text = findChild<QLabel*>();
    text->setWordWrap(false);
    const QSize whole = layout()->sizeHint();
    text->setWordWrap(whole.width() > room);
    const int across = std::min(whole.width(), room);
    resize(across, text->wordWrap() ? layout()->heightForWidth(across) : whole.height());
    // Below, where no legend is, and above the bar that tells of long work.
    move((parentWidget()->width() - width()) / 2,
         parentWidget()->height() - height() - kBorder - kRoomOfWork);
}

bool WelcomeHint::eventFilter(QObject* picture, QEvent* event)
{
    if (event->type() == QEvent::Resize) {
        place();
    }
    return QFrame::eventFilter(picture, event);
}

} // namespace crowd::app
