// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "model/bake/KeyframeStore.h"
#include "model/template/Template.h"

namespace crowd::render {
struct ThumbnailRequest;
}

namespace crowd::widgets {

/// A template that moves and can be turned by dragging, drawn without a GL widget of its own: in
/// the renderer that thumbnails share. A bar of one metre stands beside it. Main thread.
class TemplatePreview : public QWidget
{
    Q_OBJECT

public:
    TemplatePreview(model::KeyframeStore& keyframes, QWidget* parent);

    void show(model::TemplatePtr asset, int clip);
    using QWidget::show;
    [[nodiscard]] QSize sizeHint() const override { return {300, 300}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void paintGuides(QPainter& painter, const render::ThumbnailRequest& request) const;
    void beat();

    model::KeyframeStore& m_keyframes;
    model::TemplatePtr m_asset;
    int m_clip = 0;
    float m_phase = 0.0F;
    float m_turn = 0.6F;
    QPoint m_dragFrom;
    QTimer m_clock;
};

} // namespace crowd::widgets
