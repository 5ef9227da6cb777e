// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleItemDelegate.h"

#include <QtGui/QPainter>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>

namespace crowd::widgets {

namespace {

constexpr int kCountMargin = 4; ///< logical pixels
constexpr int kSentenceGap = 6; ///< between the sentences of two rules

/// Enough for some thousand times, whatever it is now; 0 where nothing is counted.
int countWidth(const QFontMetrics& metrics, const QModelIndex& index)
{
    return index.data(kRuleCountRole).isValid()
               ? metrics.horizontalAdvance(QStringLiteral("9,999 ×")) + 2 * kCountMargin
               : 0;
}

} // namespace

void RuleItemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    QStyleOptionViewItem whole = option;
    initStyleOption(&whole, index);
    const QStyle* style = whole.widget != nullptr ? whole.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &whole, painter, whole.widget);
    QStyleOptionViewItem sentence = option;
    const int width = countWidth(option.fontMetrics, index);
    sentence.rect.adjust(0, 0, -width, 0);
    QStyledItemDelegate::paint(painter, sentence, index);
    const bool isSelected = (whole.state & QStyle::State_Selected) != 0;
    if (width == 0) {
        return;
    }
    painter->save();
    painter->setPen(whole.palette.color(QPalette::Active,
                                        isSelected ? QPalette::HighlightedText : QPalette::Text));
    painter->drawText(whole.rect.adjusted(whole.rect.width() - width, 0, -kCountMargin, 0),
                      Qt::AlignRight | Qt::AlignVCenter, index.data(kRuleCountRole).toString());
    painter->restore();
}

QSize RuleItemDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem sentence = option;
    const int width = countWidth(option.fontMetrics, index);
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    const int room = view != nullptr ? view->viewport()->width() : option.rect.width();
    sentence.rect.setWidth(std::max(1, room - width));
    const QSize size = QStyledItemDelegate::sizeHint(sentence, index);
    return {size.width() + width, size.height() + kSentenceGap};
}

} // namespace crowd::widgets
