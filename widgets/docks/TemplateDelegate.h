// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QStyledItemDelegate>

namespace crowd::widgets {

/// Draws a template as a swatch: its picture, a tick in the corner that puts it into the mix, its
/// name and its share of the mix.
class TemplateDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    /// Role of the share of the mix, 0..1; below 0: not in it.
    static constexpr int kShareRole = Qt::UserRole + 1;
    static constexpr int kPictureSize = 64; ///< logical pixels

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override;
    /// Where the tick is clicked.
    [[nodiscard]] static QRect tickRect(const QRect& item);

protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
};

} // namespace crowd::widgets
