// SPDX-License-Identifier: MIT
#include "widgets/theme/Icons.h"

#include <QtCore/QFile>
#include <QtGui/QGuiApplication>
#include <QtGui/QPainter>
#include <QtGui/QPalette>
#include <QtSvg/QSvgRenderer>

namespace crowd::widgets {

namespace {

constexpr int kSizes[] = {16, 20, 24, 32, 48};
constexpr const char* kLineColor = "#202020";

QByteArray svgOf(const char* name, const QColor& color)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name)));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return file.readAll().replace(kLineColor, color.name().toLatin1());
}

QPixmap drawn(const QByteArray& svg, int size, qreal devicePixelRatio)
{
    const int pixels = qRound(size * devicePixelRatio);
    QPixmap picture(pixels, pixels);
    picture.fill(Qt::transparent);
    QSvgRenderer renderer(svg);
    QPainter painter(&picture);
    renderer.render(&painter);
    painter.end();
    picture.setDevicePixelRatio(devicePixelRatio);
    return picture;
}

} // namespace

QIcon iconNamed(const char* name)
{
    const QPalette palette = QGuiApplication::palette();
    const QByteArray normal = svgOf(name, palette.color(QPalette::Active, QPalette::ButtonText));
    const QByteArray disabled =
        svgOf(name, palette.color(QPalette::Disabled, QPalette::ButtonText));
    QIcon icon;
    if (normal.isEmpty()) {
        return icon;
    }
    for (const int size : kSizes) {
        icon.addPixmap(drawn(normal, size, 2.0), QIcon::Normal);
        icon.addPixmap(drawn(disabled, size, 2.0), QIcon::Disabled);
    }
    return icon;
}

QPixmap iconPixmap(const char* name, int size, const QColor& color, qreal devicePixelRatio)
{
    const QByteArray svg = svgOf(name, color);
    return svg.isEmpty() ? QPixmap() : drawn(svg, size, devicePixelRatio);
}

} // namespace crowd::widgets
