// SPDX-License-Identifier: MIT
#include "widgets/forms/ClipPopup.h"

#include <algorithm>
#include <utility>

#include <QtGui/QScreen>
#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneDocument.h"
#include "model/scene/Scene.h"
#include "widgets/dialogs/TemplatePreview.h"
#include "widgets/forms/ClipMix.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

namespace {

constexpr int kClipWaitMs = 350;
constexpr int kClipLeaveMs = 120;
constexpr int kClipPictureSize = 190; ///< logical pixels
constexpr int kClipPopupGap = 12;

struct Performer
{
    model::TemplatePtr asset; ///< null: nobody
    int clip = -1;
};

Performer performerOf(const model::TemplateEntry& entry, const std::string& clip)
{
    const int index = entry.asset ? entry.asset->clipIndex(clip) : -1;
    const bool isListed = std::ranges::find(entry.clipNames, clip) != entry.clipNames.end();
    return index >= 0 && isListed ? Performer{entry.asset, index} : Performer{};
}

Performer performerOf(EditorState& state, const std::string& clip)
{
    const model::Scene& scene = state.document().scene();
    const auto selected = state.selection().ids();
    const model::Population& people = scene.population;
    const std::size_t row =
        selected.empty() ? model::Population::npos : people.rowOf(selected.front());
    if (row != model::Population::npos) {
        const model::TemplateEntry* entry =
            scene.findTemplate(people.column(model::columns::templateId)[row]);
        Performer himself = entry != nullptr ? performerOf(*entry, clip) : Performer{};
        if (himself.asset) {
            return himself;
        }
    }
    for (const model::TemplateEntry& entry : scene.templates) {
        Performer somebody = performerOf(entry, clip);
        if (somebody.asset) {
            return somebody;
        }
    }
    return {};
}

} // namespace

void ClipPopup::attach(ClipMix& mix, EditorState& state)
{
    new ClipPopup(mix, state); // the list owns it
}

ClipPopup::ClipPopup(ClipMix& mix, EditorState& state)
    : QFrame(&mix, Qt::ToolTip), m_state(state), m_mix(mix),
      m_preview(new TemplatePreview(state.keyframes(), this)), m_name(new QLabel(this))
{
    setObjectName(QStringLiteral("clipPopup"));
    setFrameShape(QFrame::Box);
    setAttribute(Qt::WA_ShowWithoutActivating);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    m_preview->setFixedSize(kClipPictureSize, kClipPictureSize);
    m_name->setAlignment(Qt::AlignCenter);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(2);
    column->addWidget(m_preview);
    column->addWidget(m_name);
    m_wait.setSingleShot(true);
    m_wait.setInterval(kClipWaitMs);
    m_leave.setSingleShot(true);
    m_leave.setInterval(kClipLeaveMs);
    connect(&m_wait, &QTimer::timeout, this, &ClipPopup::present);
    connect(&m_leave, &QTimer::timeout, this, &QWidget::hide);
    connect(&mix, &ClipMix::pointedAt, this, &ClipPopup::want);
    connect(&mix, &ClipMix::left, this, [this] {
        m_wait.stop();
        m_leave.start();
    });
}

void ClipPopup::want(const std::string& clip, const QRect& name)
{
    m_clip = clip;
    m_place = name;
    m_leave.stop();
    if (isVisible()) {
        present();
    } else {
        m_wait.start();
    }
}

void ClipPopup::present()
{
    Performer somebody = performerOf(m_state, m_clip);
    if (!somebody.asset || !m_mix.isVisible()) {
        hide();
        return;
    }
    m_name->setText(QString::fromStdString(m_clip));
    m_preview->show(std::move(somebody.asset), somebody.clip);
    adjustSize();
    placeBeside(m_place);
    show();
}

/// Left of the list, or right of it where there is no room; whole on the screen.
void ClipPopup::placeBeside(const QRect& name)
{
    const QRect list(m_mix.mapToGlobal(QPoint()), m_mix.size());
    const QRect screen = m_mix.screen()->availableGeometry();
    int x = list.left() - width() - kClipPopupGap;
    if (x < screen.left()) {
        x = list.right() + kClipPopupGap;
    }
    const int highest = screen.top();
    const int lowest = std::max(highest, screen.bottom() - height());
    move(x, std::clamp(name.center().y() - height() / 2, highest, lowest));
}

void ClipPopup::hideEvent(QHideEvent* event)
{
    m_preview->show(nullptr, 0); // lets go of the template
    QFrame::hideEvent(event);
}

} // namespace crowd::widgets
