// SPDX-License-Identifier: MIT
#include "widgets/viewport/PictureSurface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include <QtGui/QOffscreenSurface>
#include <QtGui/QOpenGLContext>
#include <QtGui/QOpenGLFunctions>
#include <QtGui/QPaintEvent>
#include <QtGui/QPainter>
#include <QtOpenGL/QOpenGLFramebufferObject>
#include <QtOpenGLWidgets/QOpenGLWidget>

#include "render/gl/SoftwareTuning.h"

namespace crowd::widgets {

namespace {

PictureSurface::Kind usedKind = PictureSurface::Kind::Automatic;

QSurfaceFormat surfaceFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSamples(0); // the renderer smooths in a framebuffer of its own
    return format;
}

// As QImage::Format_RGB32 has them in memory.
constexpr GLenum kBgra = 0x80E1;
constexpr GLenum kBytesFromBlue = 0x8367; ///< GL_UNSIGNED_INT_8_8_8_8_REV

/// A context that needs no window.
class FreeContext
{
public:
    FreeContext()
    {
        m_context.setFormat(surfaceFormat());
        if (m_context.create()) {
            m_surface.setFormat(m_context.format());
            m_surface.create();
        }
    }
    [[nodiscard]] bool makeCurrent()
    {
        return m_surface.isValid() && m_context.makeCurrent(&m_surface);
    }
    void doneCurrent() { m_context.doneCurrent(); }
    [[nodiscard]] QOpenGLFunctions& functions() { return *m_context.functions(); }

private:
    QOpenGLContext m_context;
    QOffscreenSurface m_surface;
};

} // namespace

/// What Qt composes, beneath the children of the surface; the hand over it is the surface's.
class PictureSurface::Composed : public QOpenGLWidget
{
public:
    explicit Composed(PictureSurface& owner) : QOpenGLWidget(&owner), m_owner(owner)
    {
        setFormat(surfaceFormat());
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        connect(this, &QOpenGLWidget::frameSwapped, &owner, &PictureSurface::pictureShown);
    }
    /// The base class destroys the context after this; nobody is to call back into half an object.
    void end()
    {
        if (context() != nullptr) {
            disconnect(context(), nullptr, this, nullptr);
        }
        release();
        m_hasEnded = true;
    }

protected:
    void initializeGL() override
    {
        // A new context after docking: the old one was told of as it went.
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Composed::release,
                Qt::UniqueConnection);
        m_isBegun = true;
        m_owner.contextBegins();
    }
    void paintGL() override
    {
        if (!m_hasEnded) {
            (void)m_owner.choosePictureSize(); // who draws makes it as large as it is shown
            m_owner.drawPicture(defaultFramebufferObject(), m_owner.pixelSize());
            Q_EMIT m_owner.pictureDrawn();
        }
    }

private:
    void release()
    {
        if (std::exchange(m_isBegun, false)) {
            makeCurrent();
            m_owner.contextEnds(QOpenGLContext::currentContext() != nullptr);
            doneCurrent();
        }
    }

    PictureSurface& m_owner;
    bool m_isBegun = false;
    bool m_hasEnded = false;
};

/// A context, a framebuffer, and what was last drawn into it. Smaller ones are made as large as the
/// surface while they are painted, which takes less than to do so first.
class PictureSurface::Painted
{
public:
    Painted(PictureSurface& owner, std::unique_ptr<FreeContext> context)
        : m_owner(owner), m_context(std::move(context))
    {
    }
    /// Where something has changed, it is drawn first.
    [[nodiscard]] const QImage& picture()
    {
        if (m_isStale) {
            m_isStale = false;
            draw();
        }
        return m_picture;
    }
    void renew() { m_isStale = true; }
    void end()
    {
        m_hasEnded = true;
        const bool isCurrent = m_context->makeCurrent();
        if (m_isBegun) {
            m_owner.contextEnds(isCurrent);
        }
        m_frame.reset();
        m_context->doneCurrent();
    }

private:
    void draw()
    {
        if (m_hasEnded || !becomeCurrent()) {
            return;
        }
        if (!std::exchange(m_isBegun, true)) {
            m_owner.contextBegins();
        }
        const QSize size = m_owner.choosePictureSize();
        if (!m_frame || m_frame->size() != size) {
            m_frame = std::make_unique<QOpenGLFramebufferObject>(
                size, QOpenGLFramebufferObject::CombinedDepthStencil);
            m_picture = QImage(size, QImage::Format_RGB32);
            m_lines.resize(static_cast<std::size_t>(m_picture.sizeInBytes()));
            m_frame->bind(); // black, where nothing can be drawn
            m_context->functions().glClear(GL_COLOR_BUFFER_BIT);
        }
        m_owner.drawPicture(m_frame->handle(), size);
        read();
        m_context->doneCurrent();
        Q_EMIT m_owner.pictureDrawn();
        // Once it is with the window system.
        QMetaObject::invokeMethod(&m_owner, &PictureSurface::pictureShown, Qt::QueuedConnection);
    }
    /// One that is lost is made again.
    [[nodiscard]] bool becomeCurrent()
    {
        if (m_context->makeCurrent()) {
            return true;
        }
        if (std::exchange(m_isBegun, false)) {
            m_owner.contextEnds(false);
        }
        m_frame.reset();
        m_context = std::make_unique<FreeContext>();
        return m_context->makeCurrent();
    }
    /// Its rows are from the bottom.
    void read()
    {
        m_frame->bind();
        m_context->functions().glReadPixels(0, 0, m_picture.width(), m_picture.height(), kBgra,
                                            kBytesFromBlue, m_lines.data());
        m_frame->release();
        const auto stride = static_cast<std::size_t>(m_picture.bytesPerLine());
        for (int y = 0; y < m_picture.height(); ++y) {
            const auto from = static_cast<std::size_t>(m_picture.height() - 1 - y);
            std::memcpy(m_picture.scanLine(y), m_lines.data() + from * stride, stride);
        }
    }

    PictureSurface& m_owner;
    std::unique_ptr<FreeContext> m_context;
    std::unique_ptr<QOpenGLFramebufferObject> m_frame;
    std::vector<std::uint8_t> m_lines;
    QImage m_picture;
    bool m_isStale = true;
    bool m_isBegun = false;
    bool m_hasEnded = false;
};

void PictureSurface::useKind(Kind kind)
{
    usedKind = kind;
}

PictureSurface::PictureSurface(QWidget* parent) : QWidget(parent)
{
    if (usedKind != Kind::Composed) {
        auto context = std::make_unique<FreeContext>();
        const bool isUsable = context->makeCurrent();
        const bool isSoftware = isUsable && render::isSoftwareRenderer();
        context->doneCurrent(); // others have contexts of another kind
        if (isSoftware || (isUsable && usedKind == Kind::Painted)) {
            m_painted = std::make_unique<Painted>(*this, std::move(context));
            setAttribute(Qt::WA_OpaquePaintEvent);
            return;
        }
    }
    m_composed = new Composed(*this);
}

PictureSurface::~PictureSurface() = default;

void PictureSurface::renewPicture()
{
    if (m_painted) {
        m_painted->renew();
        update();
    } else {
        m_composed->update();
    }
}

QImage PictureSurface::grabPicture()
{
    if (!m_painted) {
        return m_composed->grabFramebuffer();
    }
    m_painted->renew();
    QImage picture =
        m_painted->picture().scaled(pixelSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(devicePixelRatioF());
    update();
    return picture;
}

QSize PictureSurface::pixelSize() const
{
    const QSizeF pixels = QSizeF(size()) * devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(pixels.width()))),
            std::max(1, static_cast<int>(std::lround(pixels.height())))};
}

void PictureSurface::end()
{
    if (m_painted) {
        m_painted->end();
    } else {
        m_composed->end();
    }
}

void PictureSurface::paintEvent(QPaintEvent* event)
{
    if (m_painted) {
        const QImage& picture = m_painted->picture();
        QPainter painter(this);
        painter.setClipRegion(event->region());
        painter.setCompositionMode(QPainter::CompositionMode_Source);
        painter.setRenderHint(QPainter::SmoothPixmapTransform, picture.size() != pixelSize());
        painter.drawImage(QRectF(QPointF(), QSizeF(pixelSize()) / devicePixelRatioF()), picture);
    }
}

void PictureSurface::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (m_composed != nullptr) {
        m_composed->setGeometry(rect());
    }
    renewPicture();
}

} // namespace crowd::widgets
