// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QHBoxLayout>

namespace crowd::widgets {

/// A row of fields that goes on in another line where a panel is too narrow to show what is in
/// them. A label stays with the field behind it, buttons without words with the field before them
/// unless that would be cut.
/// Space at its beginning indents all lines. Main thread.
class WrapRow : public QHBoxLayout
{
    Q_OBJECT

public:
    using QHBoxLayout::QHBoxLayout;

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] int minimumHeightForWidth(int width) const override;
    [[nodiscard]] QSize minimumSize() const override;
    [[nodiscard]] QSize sizeHint() const override;
    void setGeometry(const QRect& rect) override;

private:
    struct Field
    {
        QLayoutItem* item;
        int width; ///< that shows all of it, logical pixels
        int stretch;
    };
    using Line = std::vector<Field>;

    [[nodiscard]] int indent() const;
    [[nodiscard]] std::vector<Line> linesFor(int width) const;
    /// Fields that must not be torn apart.
    [[nodiscard]] std::vector<Line> groups() const;
    [[nodiscard]] int widthOf(const Line& line) const;
    [[nodiscard]] static int heightOf(const Line& line);
    [[nodiscard]] static bool isWordlessField(const Field& field);
    void place(Line line, const QRect& rect);
};

} // namespace crowd::widgets
