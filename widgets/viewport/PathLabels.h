// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QPointF>
#include <QtCore/QString>
#include <QtGui/QColor>

#include "model/view/View.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// A handle or a name over the picture, logical pixels.
struct PlaceLabel
{
    QPointF at;
    QString text; ///< empty: only the handle
    QColor color;
    bool isSelected = false;
    friend bool operator==(const PlaceLabel&, const PlaceLabel&) = default;
};

/// Of the places and paths that the artist works with or looks for now.
[[nodiscard]] std::vector<PlaceLabel> pathLabels(const EditorState& state, const model::View& view);

} // namespace crowd::widgets
