// SPDX-License-Identifier: MIT
#include "widgets/dialogs/TemplatePreview.h"

#include <algorithm>
#include <cmath>

#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>

#include "widgets/dialogs/TemplatePictures.h"

namespace crowd::widgets {

namespace {

constexpr int kBeatMs = 66;
constexpr float kRadiansPerPixel = 0.012F;

} // namespace

TemplatePreview::TemplatePreview(model::KeyframeStore& keyframes, QWidget* parent)
    : QWidget(parent), m_keyframes(keyframes)
{
    setMinimumSize(240, 240);
    setCursor(Qt::OpenHandCursor);
    connect(&m_clock, &QTimer::timeout, this, &TemplatePreview::beat);
    m_clock.start(kBeatMs);
}

void TemplatePreview::show(model::TemplatePtr asset, int clip)
{
    m_asset = std::move(asset);
    m_clip = clip;
    update();
}

void TemplatePreview::beat()
{
    if (!m_asset || !isVisible()) {
        return;
    }
    const float seconds = m_asset->clips[static_cast<std::size_t>(m_clip)].seconds;
    if (seconds > 0.0F) {
        m_phase += static_cast<float>(kBeatMs) / 1000.0F / seconds;
        m_phase -= std::floor(m_phase);
        update();
    }
}

void TemplatePreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (!m_asset) {
        return;
    }
    render::ThumbnailRequest request;
    request.asset = m_asset;
    request.clip = m_clip;
    request.phase = m_phase;
    request.turnRadians = m_turn;
    const int side = std::min(width(), height());
    request.size = static_cast<int>(side * devicePixelRatioF());
    QImage picture = templatePicture(m_keyframes, request);
    picture.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(QPointF((width() - side) / 2.0, (height() - side) / 2.0), picture);
}

void TemplatePreview::mousePressEvent(QMouseEvent* event)
{
    m_dragFrom = event->pos();
}

void TemplatePreview::mouseMoveEvent(QMouseEvent* event)
{
    m_turn += static_cast<float>(event->pos().x() - m_dragFrom.x()) * kRadiansPerPixel;
    m_dragFrom = event->pos();
    update();
}

} // namespace crowd::widgets
