// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QWidget>

#include "model/base/Values.h"

class QToolButton;

namespace crowd::widgets {

class WrapRow;

/// Colours side by side: a click changes one, the menu of the right button takes it out, the plus
/// adds one.
class ColourRow : public QWidget
{
    Q_OBJECT

public:
    using Colours = std::vector<model::PaintColor>;

    ColourRow(QString title, QWidget* parent);

    void setColours(const Colours& colours); ///< without signal
    [[nodiscard]] const Colours& colours() const { return m_colours; }

Q_SIGNALS:
    void edited(const Colours& colours);

private:
    void fill();
    void addSwatch(std::size_t index);
    void change(std::size_t index);
    void remove(std::size_t index);
    void add();

    QString m_title; ///< of the dialog
    Colours m_colours;
    WrapRow* m_row; ///< the layout
    std::vector<QToolButton*> m_swatches;
    QToolButton* m_add; ///< child
};

} // namespace crowd::widgets
