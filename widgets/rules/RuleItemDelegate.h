// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QStyledItemDelegate>

namespace crowd::widgets {

/// Text that is shown at the right of a rule; also an empty one has its room, no data has none.
inline constexpr int kRuleCountRole = Qt::UserRole + 40;

/// A rule's sentence, and right of it in a column of its own how often it has fired: counting moves
/// nothing.
class RuleItemDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override;
};

} // namespace crowd::widgets
