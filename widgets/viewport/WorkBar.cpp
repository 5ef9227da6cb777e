// SPDX-License-Identifier: MIT
#include "widgets/viewport/WorkBar.h"

#include <algorithm>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QToolButton>

namespace crowd::widgets {

namespace {

constexpr int kSteps = 1000;
constexpr int kBarWidth = 110;
constexpr int kBarHeight = 6;
constexpr int kBorder = 12;

/// Dark on any picture and in any theme, like the other plates over it.
const QString kStyle = QStringLiteral(R"(
#workBar { background: rgba(20, 22, 26, 215); border: none; border-radius: 7px; }
#workBar QLabel { color: rgb(235, 236, 240); background: transparent; }
#workBar QProgressBar { background: rgb(70, 72, 78); border: none; border-radius: 3px; }
#workBar QProgressBar::chunk { background: rgb(255, 170, 60); border-radius: 3px; }
#workBar QToolButton { color: rgb(255, 190, 110); border: 1px solid rgb(92, 95, 102);
                       border-radius: 4px; padding: 1px 8px; background: transparent; }
#workBar QToolButton:hover { background: rgb(70, 72, 78); }
)");

} // namespace

WorkBar::WorkBar(QWidget* parent)
    : QFrame(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)),
      m_button(new QToolButton(this))
{
    setObjectName(QStringLiteral("workBar"));
    setStyleSheet(kStyle);
    setAttribute(Qt::WA_NoMousePropagation); // else a click beside the button would paint
    m_text->setTextFormat(Qt::PlainText);
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(kBarWidth, kBarHeight);
    m_button->setFocusPolicy(Qt::NoFocus); // the keys stay the picture's
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(11, 6, 8, 6);
    layout->setSpacing(10);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_bar);
    layout->addWidget(m_button);
    connect(m_button, &QToolButton::clicked, this, &WorkBar::buttonPressed);
    hide();
}

void WorkBar::setStatus(const WorkStatus& status)
{
    if (m_status == status) {
        return;
    }
    m_status = status;
    if (m_isChanging) {
        return; // the one that is being shown is followed by this one
    }
    // The progress bar paints at once, and the picture behind it may have the next status by then.
    m_isChanging = true;
    WorkStatus shown;
    do {
        shown = m_status;
        present(shown);
    } while (shown != m_status);
    m_isChanging = false;
}

void WorkBar::present(const WorkStatus& status)
{
    m_text->setText(status.text);
    m_bar->setVisible(status.done >= 0.0);
    m_bar->setRange(0, kSteps);
    m_bar->setValue(static_cast<int>(std::clamp(status.done, 0.0, 1.0) * kSteps));
    m_button->setVisible(!status.button.isEmpty());
    m_button->setText(status.button);
    m_button->setToolTip(status.buttonTip);
    setVisible(!status.text.isEmpty());
    place();
}

void WorkBar::place()
{
    const QWidget& picture = *parentWidget();
    const int widest = std::max(80, picture.width() - 2 * kBorder);
    m_text->setWordWrap(false);
    QSize size = sizeHint();
    if (size.width() > widest) {
        m_text->setWordWrap(true);
        size = {widest, heightForWidth(widest)};
    }
    setGeometry((picture.width() - size.width()) / 2, picture.height() - size.height() - kBorder,
                size.width(), size.height());
}

} // namespace crowd::widgets
