// SPDX-License-Identifier: MIT
#include "widgets/theme/Icons.h"

#include <QtCore/QFile>
#include <QtGui/QGuiApplication>
#include <QtGui/QIconEngine>
#include <QtGui/QPainter>
#include <QtGui/QPalette>
#include <QtGui/QPixmapCache>
#include <QtSvg/QSvgRenderer>

namespace crowd::widgets {

namespace {

constexpr const char* kLineColor = "#202020";

QByteArray svgOf(const char* name, const QColor& color)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name)));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return file.readAll().replace(kLineColor, color.name().toLatin1());
}

void drawSvg(QPainter& painter, const QRectF& place, const QByteArray& svg)
{
    QSvgRenderer renderer(svg);
    renderer.render(&painter, place);
}

QPixmap drawn(const QByteArray& svg, const QSize& pixels)
{
    QPixmap picture(pixels);
    if (picture.isNull()) {
        return picture; // a button that has no room yet asks, too
    }
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    drawSvg(painter, QRectF(QPointF(), QSizeF(pixels)), svg);
    return picture;
}

/// Draws in the palette of the moment, at the size asked for: an icon that was made once follows
/// the theme and is sharp on every screen.
class ThemedIcon : public QIconEngine
{
public:
    explicit ThemedIcon(const char* name) : m_name(name) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode,
               QIcon::State /*state*/) override
    {
        drawSvg(*painter, rect, svgOf(m_name.constData(), colorOf(mode)));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/) override
    {
        const QColor color = colorOf(mode);
        const QString key = QStringLiteral("crowd-icon/%1/%2/%3x%4")
                                .arg(QLatin1String(m_name), color.name())
                                .arg(size.width())
                                .arg(size.height());
        QPixmap picture;
        if (!QPixmapCache::find(key, &picture)) {
            picture = drawn(svgOf(m_name.constData(), color), size);
            QPixmapCache::insert(key, picture);
        }
        return picture;
    }
    QString key() const override { return QStringLiteral("ThemedIcon"); }
    QIconEngine* clone() const override { return new ThemedIcon(*this); }

private:
    static QColor colorOf(QIcon::Mode mode)
    {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const auto role =
            mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
        return QGuiApplication::palette().color(group, role);
    }

    QByteArray m_name;
};

} // namespace

QIcon iconNamed(const char* name)
{
    const bool isKnown = QFile::exists(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name)));
    return isKnown ? QIcon(new ThemedIcon(name)) : QIcon();
}

QPixmap iconPixmap(const char* name, int size, const QColor& color, qreal devicePixelRatio)
{
    const QByteArray svg = svgOf(name, color);
    if (svg.isEmpty()) {
        return {};
    }
    const int pixels = qRound(size * devicePixelRatio);
    QPixmap picture = drawn(svg, {pixels, pixels});
    picture.setDevicePixelRatio(devicePixelRatio);
    return picture;
}

QIcon swatchIcon(const QColor& color)
{
    constexpr int kSide = 14; // logical pixels
    QPixmap filled(kSide, kSide);
    filled.fill(color);
    QIcon icon(filled);
    icon.addPixmap(filled, QIcon::Selected);
    return icon;
}

} // namespace crowd::widgets
