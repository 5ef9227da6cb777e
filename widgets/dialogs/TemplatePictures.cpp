// SPDX-License-Identifier: MIT
#include "widgets/dialogs/TemplatePictures.h"

#include <memory>

#include <QtCore/QCoreApplication>
#include <QtCore/QDebug>
#include <QtCore/QTimer>
#include <QtGui/QOpenGLContext>

#include "render/OffscreenContext.h"
#include "render/Renderer.h"

namespace crowd::widgets {

namespace {

/// EGL refuses while a widget's GLX context is current; that one makes itself current again before
/// it draws.
void leaveWidgetsContext()
{
    if (QOpenGLContext* current = QOpenGLContext::currentContext()) {
        current->doneCurrent();
    }
}

constexpr int kIdleMs = 2000;

/// Context and renderer, made at the first picture. The context is kept until the application
/// object dies, what was sent to the card until no picture has been asked for in a while.
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
        m_context->doneCurrent();
        m_idle.setSingleShot(true);
        m_idle.setInterval(kIdleMs);
        connect(&m_idle, &QTimer::timeout, this, &Studio::release);
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
        return drawn({request.size, request.size}, [&](render::Renderer& renderer) {
            return render::renderThumbnail(renderer, keyframes, request);
        });
    }
    QImage picture(const render::RenderInput& input, bool& isComplete)
    {
        using Pixels = model::Result<std::vector<std::uint8_t>>;
        return drawn(input.pixelSize, [&](render::Renderer& renderer) -> Pixels {
            if (auto done = renderer.draw(input); !done) {
                return done.error();
            }
            isComplete = !renderer.statistics().areKeyframesMissing;
            return renderer.readPixels();
        });
    }

private:
    /// What `draw` makes of the renderer, in the context.
    template<class Draw>
    QImage drawn(const glm::ivec2& size, const Draw& draw)
    {
        if (!m_context || !m_context->makeCurrent() || !prepare()) {
            return {};
        }
        m_idle.start();
        const auto pixels = draw(m_renderer);
        m_context->doneCurrent();
        if (!pixels) {
            return {};
        }
        return QImage(pixels.value().data(), size.x, size.y, size.x * 4, QImage::Format_RGBA8888)
            .copy();
    }
    [[nodiscard]] bool prepare()
    {
        if (m_renderer.isInitialized()) {
            return true;
        }
        const auto ready = m_renderer.initialize();
        if (!ready) {
            qWarning() << QString::fromStdString(ready.error().message);
            m_context.reset();
        }
        return ready.isOk();
    }
    /// Templates that are only here go with it.
    void release()
    {
        leaveWidgetsContext();
        if (m_context && m_context->makeCurrent()) {
            m_renderer.destroy();
            m_context->doneCurrent();
        }
    }

    std::unique_ptr<render::OffscreenContext> m_context;
    render::Renderer m_renderer;
    QTimer m_idle;
};

Studio& studio()
{
    leaveWidgetsContext();
    QObject* application = QCoreApplication::instance();
    auto* found = application->findChild<Studio*>(QStringLiteral("thumbnailStudio"),
                                                  Qt::FindDirectChildrenOnly);
    if (found == nullptr) {
        found = new Studio(application);
        found->setObjectName(QStringLiteral("thumbnailStudio"));
    }
    return *found;
}

} // namespace

QImage templatePicture(model::KeyframeStore& keyframes, const render::ThumbnailRequest& request)
{
    return studio().picture(keyframes, request);
}

QImage scenePicture(const render::RenderInput& input, bool& isComplete)
{
    isComplete = false;
    return studio().picture(input, isComplete);
}

} // namespace crowd::widgets
