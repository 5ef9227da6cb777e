// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include <QtGui/QImage>
#include <QtWidgets/QWidget>

namespace crowd::widgets {

/// Where OpenGL 3.3 draws in a window, beneath its child widgets. With a graphics card the window
/// is composed by it; where the processor draws, the picture is painted as other widgets are:
/// composing the whole window with OpenGL would take a processor longer than the picture does. The
/// class that derives from it calls end() in its destructor. Main thread only.
class PictureSurface : public QWidget
{
    Q_OBJECT

public:
    enum class Kind : std::uint8_t {
        Automatic, ///< by the renderer that the system has
        Composed,  ///< by OpenGL, in a QOpenGLWidget
        Painted    ///< from memory
    };

    explicit PictureSurface(QWidget* parent = nullptr);
    ~PictureSurface() override;

    /// Of those that are made from now on; a program decides nothing else than Automatic.
    static void useKind(Kind kind);

    /// Draws it, soon.
    void renewPicture();
    /// Drawn now, in physical pixels.
    [[nodiscard]] QImage grabPicture();
    /// Physical; one at least.
    [[nodiscard]] QSize pixelSize() const;

Q_SIGNALS:
    /// Drawn, but perhaps not shown yet.
    void pictureDrawn();
    /// And given to the window system.
    void pictureShown();

protected:
    /// A context is current, which has not been before.
    virtual void contextBegins() = 0;
    /// What the next picture is drawn with, pixelSize() or less; it is drawn at once, unless there
    /// is no context.
    [[nodiscard]] virtual QSize choosePictureSize() = 0;
    /// Draws into a framebuffer of this size, in a context that has begun and is current: the
    /// chosen one, or pixelSize().
    virtual void drawPicture(std::uint32_t framebuffer, const QSize& size) = 0;
    /// The last context goes; it is current unless it is lost.
    virtual void contextEnds(bool isCurrent) = 0;

    /// Nothing of the above is called from then on.
    void end();

    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    class Composed;
    class Painted;

    std::unique_ptr<Painted> m_painted; ///< or
    Composed* m_composed = nullptr;     ///< child widget
};

} // namespace crowd::widgets
