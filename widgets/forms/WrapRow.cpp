// SPDX-License-Identifier: MIT
#include "widgets/forms/WrapRow.h"

#include <algorithm>

#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QStyle>
#include <QtWidgets/QStyleOptionComboBox>
#include <QtWidgets/QStyleOptionSpinBox>
#include <QtWidgets/QToolButton>

namespace crowd::widgets {

namespace {

constexpr int kLineSpacing = 3;
constexpr int kTextMargin = 10; ///< around a text in its field
constexpr int kLeastText = 60;  ///< of a field to type in
constexpr int kLeastField = 30;

int widthOf(const QComboBox& box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QSize text(box.fontMetrics().horizontalAdvance(box.currentText()) + kTextMargin,
                     box.fontMetrics().height());
    return box.style()->sizeFromContents(QStyle::CT_ComboBox, &option, text, &box).width();
}

/// Of the number that is in it, not of the longest that could be.
int widthOf(const QDoubleSpinBox& box)
{
    QStyleOptionSpinBox option;
    option.initFrom(&box);
    option.frame = box.hasFrame();
    option.buttonSymbols = box.buttonSymbols();
    option.subControls = QStyle::SC_All;
    const QSize text(box.fontMetrics().horizontalAdvance(box.text()) + kTextMargin,
                     box.fontMetrics().height());
    return box.style()->sizeFromContents(QStyle::CT_SpinBox, &option, text, &box).width();
}

int widthOf(const QLineEdit& line)
{
    const QString text = line.text().isEmpty() ? line.placeholderText() : line.text();
    return std::max(kLeastText, line.fontMetrics().horizontalAdvance(text) + 2 * kTextMargin);
}

int wantedWidth(QLayoutItem& item)
{
    const QWidget* widget = item.widget();
    if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
        return widthOf(*box);
    }
    if (const auto* box = qobject_cast<const QDoubleSpinBox*>(widget)) {
        return widthOf(*box);
    }
    if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
        return widthOf(*line);
    }
    // Not the item's: a policy may forbid the layout to ask it.
    return widget != nullptr ? std::min(widget->sizeHint().width(), widget->maximumWidth())
                             : item.sizeHint().width();
}

bool isWordless(const QLayoutItem& item)
{
    const auto* button = qobject_cast<const QToolButton*>(const_cast<QLayoutItem&>(item).widget());
    return button != nullptr && button->text().isEmpty();
}

} // namespace

int WrapRow::indent() const
{
    int space = 0;
    for (int i = 0; i < count() && itemAt(i)->spacerItem() != nullptr; ++i) {
        space += itemAt(i)->sizeHint().width();
    }
    return space;
}

std::vector<WrapRow::Line> WrapRow::groups() const
{
    std::vector<Line> all;
    bool isAfterLabel = false;
    for (int i = 0; i < count(); ++i) {
        QLayoutItem* item = itemAt(i);
        if (item->spacerItem() != nullptr || item->isEmpty()) {
            continue;
        }
        if (all.empty() || !(isAfterLabel || isWordless(*item))) {
            all.emplace_back();
        }
        all.back().push_back({item, wantedWidth(*item), stretch(i)});
        isAfterLabel = qobject_cast<QLabel*>(item->widget()) != nullptr && stretch(i) == 0;
    }
    return all;
}

int WrapRow::widthOf(const Line& line) const
{
    int width = spacing() * (static_cast<int>(line.size()) - 1);
    for (const Field& field : line) {
        width += field.width;
    }
    return width;
}

int WrapRow::heightOf(const Line& line)
{
    int height = 0;
    for (const Field& field : line) {
        height = std::max(height, field.item->sizeHint().height());
    }
    return height;
}

bool WrapRow::isWordlessField(const Field& field)
{
    return isWordless(*field.item);
}

std::vector<WrapRow::Line> WrapRow::linesFor(int width) const
{
    std::vector<Line> lines;
    const int room = width - indent();
    for (const Line& group : groups()) {
        const auto words = std::ranges::find_if(group, &isWordlessField);
        if (widthOf(group) > room && words != group.begin() && words != group.end()) {
            lines.emplace_back(group.begin(), words); // rather than cut the words
            lines.emplace_back(words, group.end());
            continue;
        }
        const bool fits =
            !lines.empty() && widthOf(lines.back()) + spacing() + widthOf(group) <= room;
        if (!fits) {
            lines.emplace_back();
        }
        lines.back().insert(lines.back().end(), group.begin(), group.end());
    }
    return lines;
}

int WrapRow::heightForWidth(int width) const
{
    int height = -kLineSpacing;
    for (const Line& line : linesFor(width)) {
        height += heightOf(line) + kLineSpacing;
    }
    return std::max(height, 0);
}

int WrapRow::minimumHeightForWidth(int width) const
{
    return heightForWidth(width);
}

QSize WrapRow::minimumSize() const
{
    QSize least;
    for (const Line& group : groups()) {
        int width = spacing() * (static_cast<int>(group.size()) - 1);
        for (const Field& field : group) {
            width += field.stretch > 0 ? std::min(field.width, kLeastField) : field.width;
        }
        least = least.expandedTo({width + indent(), heightOf(group)});
    }
    return least;
}

QSize WrapRow::sizeHint() const
{
    return minimumSize();
}

void WrapRow::setGeometry(const QRect& rect)
{
    // A box would lay all of them out in one line.
    QLayout::setGeometry(rect); // NOLINT(bugprone-parent-virtual-call)
    int top = rect.top();
    for (const Line& line : linesFor(rect.width())) {
        const int height = heightOf(line);
        place(line, {rect.left() + indent(), top, rect.width() - indent(), height});
        top += height + kLineSpacing;
    }
}

/// What is over goes to those that stretch; what is missing is taken from them.
void WrapRow::place(Line line, const QRect& rect)
{
    int open = 0;
    for (const Field& field : line) {
        open += field.stretch > 0 ? 1 : 0;
    }
    int over = rect.width() - widthOf(line);
    for (Field& field : line) {
        if (field.stretch > 0) {
            const int share = over / open;
            const int width = std::max(kLeastField, field.width + share);
            over -= width - field.width;
            field.width = width;
            --open;
        }
    }
    const Qt::LayoutDirection direction =
        parentWidget() != nullptr ? parentWidget()->layoutDirection() : Qt::LeftToRight;
    const bool isAtEnd = std::ranges::all_of(line, &isWordlessField);
    int left = rect.left() + (isAtEnd ? std::max(0, over) : 0);
    for (const Field& field : line) {
        const QRect own(left, rect.top(), field.width, rect.height());
        field.item->setGeometry(QStyle::visualRect(direction, rect, own));
        left += field.width + spacing();
    }
}

} // namespace crowd::widgets
