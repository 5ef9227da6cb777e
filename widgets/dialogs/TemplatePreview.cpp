// SPDX-License-Identifier: MIT
#include "widgets/dialogs/TemplatePreview.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QLocale>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>

#include "model/view/View.h"
#include "widgets/dialogs/TemplatePictures.h"

namespace crowd::widgets {

namespace {

constexpr int kBeatMs = 66;
constexpr float kRadiansPerPixel = 0.012F;

const QColor kGuide(214, 92, 24);
const QColor kGuideText(40, 42, 48);

/// The longest of 1, 2 or 5 times a power of ten that the character reaches up to.
float measureFor(float height)
{
    if (height <= 0.0F) {
        return 1.0F;
    }
    const float ten = std::pow(10.0F, std::floor(std::log10(height)));
    for (const float step : {5.0F, 2.0F}) {
        if (step * ten <= height) {
            return step * ten;
        }
    }
    return ten;
}

/// What a square picture in the middle leaves of a rectangle, as if its edges went on.
void paintAround(QPainter& painter, const QImage& picture, const QRect& rect)
{
    const bool isWide = rect.width() > rect.height();
    const int right = picture.width() - 1;
    const int bottom = picture.height() - 1;
    const QRect low = isWide ? QRect(0, 0, 1, bottom + 1) : QRect(0, 0, right + 1, 1);
    const QRect high = isWide ? QRect(right, 0, 1, bottom + 1) : QRect(0, bottom, right + 1, 1);
    const QRect first(rect.topLeft(), isWide ? QSize(rect.width() / 2, rect.height())
                                             : QSize(rect.width(), rect.height() / 2));
    QRect second = first;
    second.moveBottomRight(rect.bottomRight());
    painter.drawImage(first, picture, low);
    painter.drawImage(second, picture, high);
}

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
    if (!m_asset) {
        painter.fillRect(rect(), palette().base());
        return;
    }
    render::ThumbnailRequest request;
    request.asset = m_asset;
    request.clip = m_clip;
    request.phase = m_phase;
    request.turnRadians = m_turn;
    const int side = std::min(width(), height());
    request.size = static_cast<int>(side * devicePixelRatioF());
    request.showGround = true;
    QImage picture = templatePicture(m_keyframes, request);
    paintAround(painter, picture, rect());
    picture.setDevicePixelRatio(devicePixelRatioF());
    painter.translate((width() - side) / 2.0, (height() - side) / 2.0);
    painter.setClipRect(0, 0, side, side);
    painter.drawImage(QPointF(), picture);
    request.size = side;
    paintGuides(painter, request);
}

/// The way it faces, and a measure of height beside it.
void TemplatePreview::paintGuides(QPainter& painter, const render::ThumbnailRequest& request) const
{
    const model::View view = render::thumbnailView(request);
    const model::Bounds& box = m_asset->bounds;
    const float reach = std::max({box.high.x, -box.low.x, box.high.z, -box.low.z, 0.01F});
    const glm::vec3 front(std::sin(m_turn), 0.0F, std::cos(m_turn));
    const glm::vec3 aside(front.z, 0.0F, -front.x);
    const auto line = [&](const glm::vec3& from, const glm::vec3& to) {
        const auto a = view.project(from);
        const auto b = view.project(to);
        if (a && b) {
            painter.drawLine(QPointF(a->x, a->y), QPointF(b->x, b->y));
        }
    };
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(kGuide, 2.5, Qt::SolidLine, Qt::RoundCap));
    const glm::vec3 tip = front * reach * 1.5F;
    line(front * reach * 1.08F, tip);
    line(tip, tip - (front + aside) * reach * 0.14F);
    line(tip, tip - (front - aside) * reach * 0.14F);
    const float measure = measureFor(m_asset->height);
    const glm::vec3 foot(-reach * 1.05F, 0.0F, 0.0F);
    const glm::vec3 head = foot + glm::vec3(0.0F, measure, 0.0F);
    const glm::vec3 tick(reach * 0.05F, 0.0F, 0.0F);
    line(foot, head);
    line(foot - tick, foot + tick);
    line(head - tick, head + tick);
    if (const auto at = view.project(head)) {
        painter.setPen(kGuideText);
        painter.drawText(QPointF(at->x + 6.0F, at->y + 12.0F),
                         tr("%1 m").arg(QLocale().toString(static_cast<double>(measure))));
    }
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
