// SPDX-License-Identifier: MIT
#include "widgets/dialogs/TemplatePictures.h"

#include <memory>

#include <QtCore/QCoreApplication>
#include <QtCore/QDebug>
#include <QtGui/QOpenGLContext>

#include "render/OffscreenContext.h"
#include "render/Renderer.h"

namespace crowd::widgets {

namespace {

/// Context and renderer, made at the first picture. Kept until the application object dies.
class Studio : public QObject
{
public:
    explicit Studio(QObject* parent) : QObject(parent)
    {
        auto context = render::OffscreenContext::create();
        if (!context) {
            qWarning() << QString::fromStdString(context.error().message);
            return;
        }
        m_context = std::move(context).value();
        if (const auto ready = m_renderer.initialize(); !ready) {
            qWarning() << QString::fromStdString(ready.error().message);
            m_context.reset();
            return;
        }
        m_context->doneCurrent();
    }
    ~Studio() override
    {
        if (m_context && m_context->makeCurrent()) {
            m_renderer.destroy();
        } else {
            m_renderer.abandon();
        }
    }

    QImage picture(model::KeyframeStore& keyframes, const render::ThumbnailRequest& request)
    {
        if (!m_context || !m_context->makeCurrent()) {
            return {};
        }
        const auto pixels = render::renderThumbnail(m_renderer, keyframes, request);
        m_context->doneCurrent();
        if (!pixels) {
            return {};
        }
        return QImage(pixels.value().data(), request.size, request.size, request.size * 4,
                      QImage::Format_RGBA8888)
            .copy();
    }

private:
    std::unique_ptr<render::OffscreenContext> m_context;
    render::Renderer m_renderer;
};

} // namespace

QImage templatePicture(model::KeyframeStore& keyframes, const render::ThumbnailRequest& request)
{
    // EGL refuses while a widget's GLX context is current; that one makes itself current again
    // before it draws.
    if (QOpenGLContext* current = QOpenGLContext::currentContext()) {
        current->doneCurrent();
    }
    QObject* application = QCoreApplication::instance();
    auto* studio = application->findChild<Studio*>(QStringLiteral("thumbnailStudio"),
                                                   Qt::FindDirectChildrenOnly);
    if (studio == nullptr) {
        studio = new Studio(application);
        studio->setObjectName(QStringLiteral("thumbnailStudio"));
    }
    return studio->picture(keyframes, request);
}

} // namespace crowd::widgets
