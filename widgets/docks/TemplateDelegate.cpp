// SPDX-License-Identifier: MIT
#include "widgets/docks/TemplateDelegate.h"

#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>

namespace crowd::widgets {

namespace {

constexpr int kPictureMargin = 5;
constexpr int kTick = 18;

QRect pictureRect(const QRect& item)
{
    const int left = item.left() + (item.width() - TemplateDelegate::kPictureSize) / 2;
    return {left, item.top() + kPictureMargin, TemplateDelegate::kPictureSize,
            TemplateDelegate::kPictureSize};
}

QRect nameRect(const QRect& item, int lineHeight)
{
    return {item.left() + 2, pictureRect(item).bottom() + 2, item.width() - 4, lineHeight};
}

/// A full disc with a tick, or an empty one: plain on any picture and in any theme.
void drawTick(QPainter& painter, const QRect& place, bool isOn, const QPalette& palette)
{
    const QRectF disc = QRectF(place).adjusted(2.5, 2.5, -2.5, -2.5);
    painter.setPen(QPen(palette.color(isOn ? QPalette::Highlight : QPalette::Text), 1.4));
    painter.setBrush(isOn ? palette.brush(QPalette::Highlight) : palette.brush(QPalette::Base));
    painter.drawEllipse(disc);
    if (isOn) {
        const QPointF middle = disc.center();
        painter.setPen(QPen(palette.color(QPalette::HighlightedText), 1.8, Qt::SolidLine,
                            Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(QPolygonF{middle + QPointF(-3.2, 0.2), middle + QPointF(-1.0, 2.6),
                                       middle + QPointF(3.2, -2.4)});
    }
}

} // namespace

QRect TemplateDelegate::tickRect(const QRect& item)
{
    const QRect picture = pictureRect(item);
    return {picture.left() - 3, picture.top() - 3, kTick, kTick};
}

QSize TemplateDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return {kPictureSize + 2 * kPictureMargin,
            kPictureSize + 2 * kPictureMargin + 2 * option.fontMetrics.height()};
}

void TemplateDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QPalette& palette = option.palette;
    const QRect all = option.rect.adjusted(1, 1, -1, -1);
    if (option.state.testFlag(QStyle::State_Selected)) {
        QColor ground = palette.color(QPalette::Highlight);
        ground.setAlphaF(0.25F);
        painter->setPen(QPen(palette.color(QPalette::Highlight), 1.0));
        painter->setBrush(ground);
        painter->drawRoundedRect(all, 4.0, 4.0);
    }
    const double share = index.data(kShareRole).toDouble();
    const bool isIn = share >= 0.0;
    const QRect picture = pictureRect(option.rect);
    painter->setOpacity(isIn ? 1.0 : 0.5);
    index.data(Qt::DecorationRole).value<QIcon>().paint(painter, picture);
    painter->setOpacity(1.0);
    drawTick(*painter, tickRect(option.rect), isIn, palette);
    const int line = option.fontMetrics.height();
    const QRect name = nameRect(option.rect, line);
    painter->setPen(palette.color(QPalette::Text));
    painter->drawText(name, Qt::AlignCenter,
                      option.fontMetrics.elidedText(index.data(Qt::DisplayRole).toString(),
                                                    Qt::ElideRight, name.width()));
    if (isIn) {
        painter->setPen(palette.color(QPalette::PlaceholderText));
        painter->drawText(name.translated(0, line), Qt::AlignCenter,
                          tr("%1 %").arg(qRound(share * 100.0)));
    }
    painter->restore();
}

bool TemplateDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                                   const QStyleOptionViewItem& option, const QModelIndex& index)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
        break;
    default:
        return QStyledItemDelegate::editorEvent(event, model, option, index);
    }
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton ||
        !tickRect(option.rect).contains(mouse->position().toPoint())) {
        return false;
    }
    if (event->type() == QEvent::MouseButtonRelease) {
        const bool isOn = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        return model->setData(index, isOn ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    }
    return true;
}

void TemplateDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                            const QModelIndex&) const
{
    editor->setGeometry(nameRect(option.rect, option.fontMetrics.height() + 4));
}

} // namespace crowd::widgets
